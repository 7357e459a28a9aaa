#pragma once

#include "visibility/scene/prepared_scene.hpp"

#include <optional>
#include <utility>
#include <vector>

namespace visibility::strong_occlusion {

/// What is left of a scene for a cell and for all cells inside it: the objects that may be visible, and the bodies that
/// may be the strong occluder of something. A body that has a strong occluder itself is not needed: what it hides, that
/// one hides (proofs/strong_occlusion.md, Theorem 3). At first all of the scene. Keeps a reference to it.
class Remainder {
public:
  using Item = std::uint32_t;  ///< position among the objects, or among the bodies, of the remainder

  /// The whole scene; the hierarchies are shared with it.
  explicit Remainder(PreparedScene const& scene)
    : scene_(&scene), shared_objects_(&scene.object_hierarchy()), shared_bodies_(&scene.body_hierarchy())
  {
  }

  PreparedScene const& scene() const { return *scene_; }
  /// Node i of both hierarchies stands for the same objects.
  BoundingHierarchy const& objects() const { return shared_objects_ != nullptr ? *shared_objects_ : own_objects_; }
  BoundingHierarchy const& bodies() const { return shared_bodies_ != nullptr ? *shared_bodies_ : own_bodies_; }
  std::uint32_t object(Item i) const { return shared_objects_ != nullptr ? i : object_ids_[i]; }
  std::uint32_t body(Item i) const { return shared_bodies_ != nullptr ? i : body_ids_[i]; }
  Box const& body_bounds(Item i) const { return scene_->bodies().bounds()[body(i)]; }
  /// Whether the object is hidden from a larger cell; then only its bodies are of interest.
  bool is_settled(Item object) const { return shared_objects_ == nullptr && settled_[object]; }
  /// The bodies of an object: items first, ..., last - 1.
  std::pair<Item, Item> bodies_of(Item object) const
  {
    auto const first =
      shared_objects_ != nullptr ? scene_->bodies().first_of_object() : std::span<Item const>(first_of_object_);
    return {first[object], first[object + 1]};
  }

  /// An object to be kept, for itself or only for its bodies.
  struct Kept {
    Item object;
    bool settled;
  };
  /// What is left for smaller cells. `redundant(body)` says which bodies of the kept objects are left out; a settled
  /// object all of whose bodies are redundant is left out too.
  template <class Redundant>
  Remainder keep(std::span<Kept const> objects, Redundant&& redundant) const
  {
    Remainder out;
    out.scene_ = scene_;
    std::vector<Box> object_bounds, body_bounds;
    for (auto const& [object, settled] : objects) {
      auto const before = static_cast<Item>(out.body_ids_.size());
      auto const [first, last] = bodies_of(object);
      for (Item b = first; b < last; ++b)
        if (!redundant(b)) out.body_ids_.push_back(body(b)), body_bounds.push_back(this->body_bounds(b));
      if (out.body_ids_.size() == before) continue;
      out.first_of_object_.push_back(before);
      out.object_ids_.push_back(this->object(object));
      out.settled_.push_back(settled);
      object_bounds.push_back(scene_->object_bounds()[this->object(object)]);
    }
    out.first_of_object_.push_back(static_cast<Item>(out.body_ids_.size()));
    out.own_objects_ = BoundingHierarchy(object_bounds);
    out.own_bodies_ = BoundingHierarchy(out.own_objects_, out.first_of_object_, body_bounds);
    return out;
  }

private:
  Remainder() = default;

  PreparedScene const* scene_ = nullptr;
  BoundingHierarchy const *shared_objects_ = nullptr, *shared_bodies_ = nullptr;
  BoundingHierarchy own_objects_, own_bodies_;
  std::vector<std::uint32_t> object_ids_, body_ids_;
  std::vector<Item> first_of_object_;
  std::vector<bool> settled_;
};

}  // namespace visibility::strong_occlusion
