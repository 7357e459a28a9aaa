#pragma once

// The only header that knows which Catch2 is there.
#ifdef VISIBILITY_CATCH2_V3
#include <catch2/catch_all.hpp>
#else
#include <catch2/catch.hpp>
#endif

#include <rapidcheck.h>

namespace visibility::test {

/// Runs a RapidCheck property inside a Catch2 test case; a counterexample, shrunk, is the failure message.
template <class Testable>
void property(std::string const& law, Testable&& testable)
{
  auto const result = rc::detail::checkTestable(std::forward<Testable>(testable), rc::detail::TestMetadata{law, law});
  std::ostringstream text;
  rc::detail::printResultMessage(result, text);
  INFO(law << "\n" << text.str());
  REQUIRE(result.template is<rc::detail::SuccessResult>());
}

}  // namespace visibility::test
