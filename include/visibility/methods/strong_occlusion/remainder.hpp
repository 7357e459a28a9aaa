#pragma once

#include "visibility/scene/prepared_scene.hpp"

#include <optional>
#include <utility>
#include <vector>

namespace visibility::strong_occlusion {

/// What is left of a scene for a cell and for all cells inside it: the objects that may be visible, and the occluders
/// that may be the strong occluder of something. One that has a strong occluder itself is not needed: what it hides,
/// that one hides (proofs/strong_occlusion.md, Theorem 3). At first all of the scene. Keeps a reference to it.
class Remainder {
public:
  using Item = std::uint32_t;  ///< position among the objects, or among the occluders, of the remainder

  /// The whole scene; the hierarchies are shared with it.
  explicit Remainder(PreparedScene const& scene)
    : scene_(&scene), shared_objects_(&scene.object_hierarchy()), shared_occluders_(&scene.occluder_hierarchy())
  {
  }

  PreparedScene const& scene() const { return *scene_; }
  /// Node i of both hierarchies stands for the same objects.
  BoundingHierarchy const& objects() const { return shared_objects_ != nullptr ? *shared_objects_ : own_objects_; }
  BoundingHierarchy const& occluders() const
  {
    return shared_occluders_ != nullptr ? *shared_occluders_ : own_occluders_;
  }
  std::uint32_t object(Item i) const { return shared_objects_ != nullptr ? i : object_ids_[i]; }
  /// Its position in scene().occluders().
  std::uint32_t occluder(Item i) const { return shared_occluders_ != nullptr ? i : occluder_ids_[i]; }
  Box const& bounds(Item occluder_item) const { return scene_->occluders().bounds()[occluder(occluder_item)]; }
  /// The body that the occluder is; null for a body inside an object.
  ConvexBodies::Body const* body(Item occluder_item) const
  {
    auto const i = occluder(occluder_item);
    auto const& all = scene_->occluders();
    return all.is_body(i) ? &scene_->bodies().bodies()[all.body(i)] : nullptr;
  }
  /// Whether the object is hidden from a larger cell; then only its occluders are of interest.
  bool is_settled(Item object) const { return shared_objects_ == nullptr && settled_[object]; }
  /// The occluders of an object: items first, ..., last - 1; its bodies come before bodies inside it.
  std::pair<Item, Item> occluders_of(Item object) const
  {
    auto const first =
      shared_objects_ != nullptr ? scene_->occluders().first_of_object() : std::span<Item const>(first_of_object_);
    return {first[object], first[object + 1]};
  }

  /// An object to be kept, for itself or only for its occluders.
  struct Kept {
    Item object;
    bool settled;
  };
  /// What is left for smaller cells. `redundant(occluder)` says which occluders of the kept objects are left out; an
  /// object that keeps none is left out too. Requires: an object that is not settled keeps one.
  template <class Redundant>
  Remainder keep(std::span<Kept const> objects, Redundant&& redundant) const
  {
    Remainder out;
    out.scene_ = scene_;
    std::vector<Box> object_bounds, occluder_bounds;
    for (auto const& [object, settled] : objects) {
      auto const before = static_cast<Item>(out.occluder_ids_.size());
      auto const [first, last] = occluders_of(object);
      for (Item b = first; b < last; ++b)
        if (!redundant(b)) out.occluder_ids_.push_back(occluder(b)), occluder_bounds.push_back(bounds(b));
      if (out.occluder_ids_.size() == before) continue;
      out.first_of_object_.push_back(before);
      out.object_ids_.push_back(this->object(object));
      out.settled_.push_back(settled);
      object_bounds.push_back(scene_->object_bounds()[this->object(object)]);
    }
    out.first_of_object_.push_back(static_cast<Item>(out.occluder_ids_.size()));
    out.own_objects_ = BoundingHierarchy(object_bounds);
    out.own_occluders_ = BoundingHierarchy(out.own_objects_, out.first_of_object_, occluder_bounds);
    return out;
  }

private:
  Remainder() = default;

  PreparedScene const* scene_ = nullptr;
  BoundingHierarchy const *shared_objects_ = nullptr, *shared_occluders_ = nullptr;
  BoundingHierarchy own_objects_, own_occluders_;
  std::vector<std::uint32_t> object_ids_, occluder_ids_;
  std::vector<Item> first_of_object_;
  std::vector<bool> settled_;
};

}  // namespace visibility::strong_occlusion
