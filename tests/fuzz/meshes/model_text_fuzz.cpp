// What Noonmark's own process reads of a mesh file before the mesh library does: place, north and unit of an
// IFC, unit of a DXF, offset of a PLY. Each reader gets every input.
#include <array>
#include <cmath>

#include "core/io/meshes/ifc_site.h"
#include "core/io/meshes/stated_axes.h"
#include "tests/fuzz/fuzz_file.h"
#include "tests/fuzz/require.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace noonmark;
    using namespace noonmark::tests;
    const std::string_view text = formatText(data, size);
    for (const char* name : {"model.ifc", "model.dxf", "model.dae", "model.ply"}) {
        const auto axes = findStatedAxes(fuzzFile(name, text));
        require(!axes || !axes->metresPerUnit ||
                    (std::isfinite(*axes->metresPerUnit) && *axes->metresPerUnit > 0),
                "a unit is a length");
    }
    const IfcSite site = readIfcSite(fuzzFile("model.ifc", text), {});
    (void)describe(site);
    if (const auto place = findPlace(site))
        require(std::abs(place->origin.lonDeg) <= 180 && std::abs(place->origin.latDeg) <= 90 &&
                    std::isfinite(place->northDeg) && std::isfinite(place->elevationM),
                "a place lies on the earth");
    if (const auto offset = readPlyOffset(fuzzFile("model.ply", text)))
        require(std::isfinite(offset->x + offset->y + offset->z), "an offset is finite");
    return 0;
}
