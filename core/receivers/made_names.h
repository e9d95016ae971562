#pragma once

#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>

#include "core/describe/answer_page.h"
#include "core/describe/text.h"

namespace noonmark {

/// Names that the program makes, most of them from those of the data. "%1" is the street, or a longer part of
/// it.
namespace madeNames {
inline constexpr std::string_view carriageway = NM_TEXT("%1, carriageway"),
                                  sidewalks = NM_TEXT("%1, sidewalks"), between = NM_TEXT("%1, %2 to %3"),
                                  at = NM_TEXT("%1, at %2"), severalSources = NM_TEXT("%1 and %2 more");
/// Regions. "%1" is a building or what else stands in the middle.
inline constexpr std::string_view wholeCity = NM_TEXT("the whole city"),
                                  cityMiddle = NM_TEXT("the middle of the city"),
                                  aroundBuilding = NM_TEXT("around the building"),
                                  around = NM_TEXT("around %1");
/// Counter-clockwise from the east.
inline constexpr std::string_view winds[] = {NM_TEXT("%1, east of %2"),  NM_TEXT("%1, north-east of %2"),
                                             NM_TEXT("%1, north of %2"), NM_TEXT("%1, north-west of %2"),
                                             NM_TEXT("%1, west of %2"),  NM_TEXT("%1, south-west of %2"),
                                             NM_TEXT("%1, south of %2"), NM_TEXT("%1, south-east of %2")};
}  // namespace madeNames

inline std::string makeName(std::string_view pattern, std::initializer_list<std::string> of) {
    return fillIn(pattern, {of.begin(), of.size()});
}

/// "Garden" for 1, "Garden (2)" for 2: the second of that name.
std::string numberName(std::string_view name, std::size_t number);

struct NumberedName {
    std::string_view name;    ///< "Garden"
    std::string_view number;  ///< " (2)"
};
/// None: the name has no number.
std::optional<NumberedName> splitNumber(std::string_view name);

/// A made name as a sentence, whose arguments may be made names, too. None: the name is the data's or the
/// user's. A name that only reads like a made one is taken for it.
std::optional<Sentence> findMadeName(std::string_view name);

}  // namespace noonmark
