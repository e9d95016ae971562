#include "core/describe/text.h"
#include "core/engines/graph/direction_graph.h"

namespace noonmark {

const Fields<DirectionGraphSettings>& graphFields() {
    static const Fields<DirectionGraphSettings> fields{
        field(&DirectionGraphSettings::intervalMinutes,
              {.key = "interval",
               .label = NM_TEXT("Interval"),
               .help = NM_TEXT("How long the sun is taken to move in a straight line"),
               .unit = "min",
               .range = ValueRange{0.1, 120}}),
        field(&DirectionGraphSettings::boundDeg,
              {.key = "bound",
               .label = NM_TEXT("Direction bound"),
               .help = NM_TEXT("Hours whose sun is less than this apart are computed once"),
               .unit = "deg",
               .range = ValueRange{0.1, 20}})};
    return fields;
}

}  // namespace noonmark
