#include "core/io/settings/read_settings.h"

#include <array>

#include "core/base/units.h"
#include "core/describe/text.h"

namespace noonmark {

std::span<const LengthUnitEntry> listLengthUnits() {
    static constexpr std::array units{
        LengthUnitEntry{LengthUnit::metres, "m", "m", NM_TEXT("metres"), 1},
        LengthUnitEntry{LengthUnit::feet, "ft", "ft", NM_TEXT("feet"), metresPerFoot},
        LengthUnitEntry{LengthUnit::usSurveyFeet, "us-ft", "US survey ft", NM_TEXT("US survey feet"),
                        1200.0 / 3937.0},
        LengthUnitEntry{LengthUnit::centimetres, "cm", "cm", NM_TEXT("centimetres"), 0.01},
        LengthUnitEntry{LengthUnit::millimetres, "mm", "mm", NM_TEXT("millimetres"), 0.001},
        LengthUnitEntry{LengthUnit::inches, "in", "in", NM_TEXT("inches"), 0.0254},
        LengthUnitEntry{LengthUnit::decimetres, "dm", "dm", NM_TEXT("decimetres"), 0.1},
    };
    return units;
}

const LengthUnitEntry& entryOf(LengthUnit unit) { return listLengthUnits()[std::size_t(unit)]; }

std::string crsAdvice() {
    return "State its coordinate reference system: " + readOption("crs", "EPSG:number");
}

std::string anchorAdvice() {
    return "State the longitude and latitude of the mesh's origin (" + readOption("mesh_anchor", "LON,LAT") +
           "), or the coordinate reference system of its coordinates (" + readOption("crs", "EPSG:number") +
           "), or open it together with a file that has a position";
}

bool asksForPlace(const Error& error) {
    return error.advice.starts_with(crsAdvice()) || error.advice.starts_with(anchorAdvice());
}

}  // namespace noonmark
