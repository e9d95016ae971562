#include "core/io/settings/place_advice.h"

#include "core/io/settings/read_fields.h"

namespace noonmark {

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
