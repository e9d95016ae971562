// Footprints as GeoPackage with changed cells in its tables, including those of the standard.
#include "core/io/write_city.h"
#include "tests/fuzz/fuzz_file.h"
#include "tests/fuzz/sound.h"
#include "tests/fuzz/table_edits.h"
#include "tests/scenarios/small_town.h"

namespace {

noonmark::tests::TableEdits goodFile() {
    const auto file = noonmark::tests::fuzzFolder() / "good.gpkg";
    const auto written = noonmark::writeCityGeoPackage(file, noonmark::tests::threeHouses());
    noonmark::tests::require(written.has_value(), "a GeoPackage is written");
    return noonmark::tests::TableEdits(file);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace noonmark::tests;
    static const TableEdits edits = goodFile();
    noonmark::NoProgress progress;
    use(noonmark::readFootprints(edits.edited("footprints.gpkg", {data, size}), {}, progress, {}));
    return 0;
}
