#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "core/base/warnings.h"
#include "core/city/building_heights.h"
#include "core/city/trees/tree.h"
#include "core/describe/answer_page.h"
#include "core/io/heights/height_facts.h"

namespace noonmark {

struct CityRead;

/// {fields: [{file, field, meaning, unit, features}], could_be: [{file, field, low, high, whole, features}],
/// bases: [{file, buildings, gap_m, spread_m, rule, aloft, apart, text}]}
nlohmann::ordered_json heightFactsJson(const HeightFacts& facts);

/// Parses such JSON; nothing if it has another structure or a wrong number.
std::optional<HeightFacts> parseHeightFacts(const std::string& text);

/// "22,133 of 22,133 heights are assumed (9.6 m)" if more than maxAssumedShare are assumed; else nothing.
std::optional<std::string> makeAssumedHeadline(const HeightCounts& counts);

/// The same as a sentence.
std::optional<Sentence> describeAssumed(const HeightCounts& counts);

/// Says of each field of heights whose unit is doubtful what is, and the options that settle it; nothing
/// without such a field.
std::optional<std::string> makeDoubtHeadline(const HeightFacts& facts);

/// Says of each file whose buildings were not left at the elevations that it states how they were placed;
/// nothing without such a file.
std::optional<std::string> makeStandHeadline(const HeightFacts& facts);

/// "Estimated or assumed of 2,931 trees: height of 2,931, crown of 412" if more than maxAssumedShare of
/// either are; else nothing. Null: no trees.
std::optional<Sentence> describeEstimatedTrees(const std::shared_ptr<const Trees>& trees);

/// A line above the figures of a city's study: what its geometry owes to assumptions.
struct GeometryHeadline {
    std::string of;  ///< "heights", "unit of heights", "bases", "heights of trees"
    std::string text;
};
std::vector<GeometryHeadline> listGeometryHeadlines(const City& city, const HeightFacts& facts);

/// What a message says of heights that may be wrong: how many are assumed and the fields that the user could
/// choose, fields whose unit is doubtful, buildings that were not left at the elevations of their file; then
/// describeEstimatedTrees().
std::vector<Sentence> describeHeights(const City& city, const HeightFacts& facts);

/// {parts, by_source: {measured: parts, ...}, assumed_share, assumed_m, fields: [{file, field, meaning, unit,
/// features}], could_be: [{file, field, low, high, whole, features}], doubts: [...], bases: [...]}; assumed_m
/// is null if no heights are assumed.
nlohmann::ordered_json heightsJson(const HeightCounts& counts, const HeightFacts& facts);

/// How many warnings there are of each kind, and how many of them are of buildings that were there twice:
/// {repaired, clipped, dropped, left_out, assumed, duplicates}
nlohmann::ordered_json changesJson(const Warnings& warnings);

struct ReadingChange {
    std::string kind;  ///< "repaired", "left out", "duplicates"
    std::size_t count = 0;
};
std::vector<ReadingChange> countChanges(const Warnings& warnings);

/// "46 repaired, 2 dropped"; "nothing" without warnings.
std::string describeChanges(const Warnings& warnings);

/// What was read: format and place, size, ground.
std::vector<Sentence> listFacts(const CityRead& read);

/// The same at a glance: "GeoJSON (WGS 84, as the file states), 0.4 km from Monaco, Monaco. Buildings: 12,
/// parts: 15, up to 40 m high. On flat ground. Changed in reading: 46 repaired (40: its surface is not
/// closed; it is used unchanged); 2 dropped (surfaces without area)."
std::string summariseReading(const CityRead& read);

}  // namespace noonmark
