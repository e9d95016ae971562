// A register of parcels.
#include "core/io/footprints/read_parcels.h"
#include "tests/fuzz/fuzz_file.h"
#include "tests/fuzz/require.h"
#include "tests/fuzz/sound.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace noonmark::tests;
    const auto file = fuzzFile("parcels.geojson", formatText(data, size));
    const auto parcels = noonmark::readParcels(file, {}, noonmark::Frame({-73.98, 40.75}), {});
    if (!parcels) return requireSound(parcels.error()), 0;
    for (const noonmark::Parcel& parcel : *parcels) {
        require(!parcel.polygons.empty(), "a parcel has a polygon");
        requireSound(parcel.polygons);
    }
    return 0;
}
