# Embree 4 or 3, as the target `visibility_embree`; sources tell them apart by RTC_VERSION_MAJOR.
if(NOT TARGET embree)
  find_package(embree 4 QUIET)
  if(NOT embree_FOUND)
    find_package(embree 3 REQUIRED)
  endif()
endif()
