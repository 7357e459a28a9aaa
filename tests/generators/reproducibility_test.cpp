#include "support.hpp"

#include <array>
#include <cstdio>
#include <map>

using namespace visibility;
using test::fingerprint;

namespace {

/// Small scenes in which every parameter matters.
struct Sample {
  std::string kind;
  std::map<std::string, double> values;
  std::uint64_t fingerprint;  ///< of the sample; the same on every machine and with every compiler
};

Sample const samples[] = {
  {"city", {{"n", 100}}, 0x617230828A0A7832},
  {"spheres", {{"n", 4}}, 0x593D17E91FD63007},
  {"circles", {{"n", 5}}, 0x96CFEFD85708AB84},
  {"slanted", {{"n", 30}}, 0x3DA93AE941FC3FBC},
  {"urban", {{"n", 60}, {"block", 1}, {"blocks", 2}}, 0xDDD68BAA9214887E},
  {"box-field", {{"n", 100}}, 0x0E9B2C13EE4FC73F},
  {"forest", {{"n", 5}, {"leaves", 50}}, 0xE6B7723BC7763205},
  {"district", {{"n", 9}, {"block", 1}}, 0x9D1F8FA40736220D},
};

std::string specification(std::string const& kind, std::map<std::string, double> const& values)
{
  std::string s = kind;
  for (auto const& [key, value] : values) {
    std::array<char, 40> buffer{};
    std::snprintf(buffer.data(), buffer.size(), ",%s=%.17g", key.c_str(), value);
    s += buffer.data();
  }
  return s;
}

GeneratorKind const& kind_of(Sample const& sample)
{
  return *std::ranges::find(generator_kinds(), sample.kind, &GeneratorKind::name);
}

/// Another valid value.
double other(GeneratorParameter const& p, double value)
{
  if (p.type == GeneratorParameter::Type::integer) return value < p.max ? value + 1 : value - 1;
  if (p.max == 1) return value <= 0.5 ? value + 0.4 : value - 0.4;  // shares: enough for a small sample to notice
  if (value == 0) return std::min(1.0, p.max);
  return value * 1.1 <= p.max ? value * 1.1 : value * 0.9;
}

}  // namespace

TEST_CASE("reproducible: a specification gives the same scene on every machine", "[generators]")
{
  REQUIRE(std::size(samples) == generator_kinds().size());
  for (auto const& sample : samples) {
    auto const scene = generate(specification(sample.kind, sample.values));
    scene.validate();
    CAPTURE(sample.kind);
    CHECK(fingerprint(scene) == sample.fingerprint);
    REQUIRE(fingerprint(generate(specification(sample.kind, sample.values))) == fingerprint(scene));
  }
  // Code that the samples do not reach.
  CHECK(fingerprint(generate("urban,n=20,tilt=30")) == 0xD1E43DC742E079FF);
  CHECK(fingerprint(generate("district,n=4,rotation=33")) == 0x9C818008EAFFC80B);
  CHECK(fingerprint(generate("forest,n=4,leaves=5,trunk=1")) == 0x211A105015255EA1);
  CHECK(fingerprint(generate("city,n=40,triples=0.5")) == 0xC8B3FCC94D76130A);
}

TEST_CASE("reproducible: every parameter changes the scene", "[generators]")
{
  for (auto const& sample : samples) {
    auto const plain = fingerprint(generate(specification(sample.kind, sample.values)));
    for (auto const& p : kind_of(sample).parameters) {
      auto values = sample.values;
      auto const [it, fresh] = values.try_emplace(p.name, p.value);
      // Giving a default changes nothing.
      if (fresh) REQUIRE(fingerprint(generate(specification(sample.kind, values))) == plain);
      it->second = other(p, it->second);
      CAPTURE(specification(sample.kind, values));
      auto const scene = generate(specification(sample.kind, values));
      scene.validate();
      REQUIRE(fingerprint(scene) != plain);
    }
  }
}

TEST_CASE("reproducible: a longer scene starts with the objects of the shorter one", "[generators]")
{
  // Not so: balls (the grid is counted along its sides), towers of a city (their number is exact), a box field (its
  // side follows from the number of boxes).
  for (std::string const kind : {"city,triples=0", "slanted", "urban", "forest,leaves=20", "district"}) {
    CAPTURE(kind);
    auto const small = generate(kind + ",n=20"), large = generate(kind + ",n=33");
    REQUIRE(large.objects.size() > small.objects.size());
    for (std::size_t i = 0; i < small.objects.size(); ++i) {
      REQUIRE(small.objects[i].name == large.objects[i].name);
      REQUIRE(bounding_box(small, small.objects[i]) == bounding_box(large, large.objects[i]));
    }
    REQUIRE(std::ranges::equal(small.vertices, std::span(large.vertices).first(small.vertices.size())));
    REQUIRE(std::ranges::equal(small.triangles, std::span(large.triangles).first(small.triangles.size())));
  }
}
