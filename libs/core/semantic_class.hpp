// What a surface belongs to: the 20 classes of the ScanNet benchmark and otherprop, as in 5.2.1 and 5.3.2.2 of the
// thesis. The values are the class numbers of NYU40, which ScanNet's files use; 0 is what nobody labelled.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

namespace amiss {

enum class SemanticClass : std::uint8_t {
  kUnlabelled = 0,
  kWall = 1,
  kFloor = 2,
  kCabinet = 3,
  kBed = 4,
  kChair = 5,
  kSofa = 6,
  kTable = 7,
  kDoor = 8,
  kWindow = 9,
  kBookshelf = 10,
  kPicture = 11,
  kCounter = 12,
  kDesk = 14,
  kCurtain = 16,
  kRefrigerator = 24,
  kShowerCurtain = 28,
  kToilet = 33,
  kSink = 34,
  kBathtub = 36,
  kOtherFurniture = 39,
  kOtherProp = 40,
};

struct NamedSemanticClass {
  SemanticClass value;
  std::string_view name;
};

/// All of them in the order of their values, kUnlabelled first; names as ScanNet writes them, without spaces.
inline constexpr std::array<NamedSemanticClass, 22> kSemanticClasses{{{SemanticClass::kUnlabelled, "unlabelled"},
                                                                      {SemanticClass::kWall, "wall"},
                                                                      {SemanticClass::kFloor, "floor"},
                                                                      {SemanticClass::kCabinet, "cabinet"},
                                                                      {SemanticClass::kBed, "bed"},
                                                                      {SemanticClass::kChair, "chair"},
                                                                      {SemanticClass::kSofa, "sofa"},
                                                                      {SemanticClass::kTable, "table"},
                                                                      {SemanticClass::kDoor, "door"},
                                                                      {SemanticClass::kWindow, "window"},
                                                                      {SemanticClass::kBookshelf, "bookshelf"},
                                                                      {SemanticClass::kPicture, "picture"},
                                                                      {SemanticClass::kCounter, "counter"},
                                                                      {SemanticClass::kDesk, "desk"},
                                                                      {SemanticClass::kCurtain, "curtain"},
                                                                      {SemanticClass::kRefrigerator, "refrigerator"},
                                                                      {SemanticClass::kShowerCurtain, "showercurtain"},
                                                                      {SemanticClass::kToilet, "toilet"},
                                                                      {SemanticClass::kSink, "sink"},
                                                                      {SemanticClass::kBathtub, "bathtub"},
                                                                      {SemanticClass::kOtherFurniture, "otherfurniture"},
                                                                      {SemanticClass::kOtherProp, "otherprop"}}};

[[nodiscard]] constexpr std::string_view to_string(SemanticClass value) {
  for (const NamedSemanticClass& named : kSemanticClasses) {
    if (named.value == value) return named.name;
  }
  return "?";
}

[[nodiscard]] constexpr std::optional<SemanticClass> semantic_class_of(std::string_view name) {
  for (const NamedSemanticClass& named : kSemanticClasses) {
    if (named.name == name) return named.value;
  }
  return std::nullopt;
}

}  // namespace amiss
