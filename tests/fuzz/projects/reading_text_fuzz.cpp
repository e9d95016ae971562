// How a project's city was read: the settings, the height fields, and the terrain's source.
#include "core/io/settings/read_settings.h"
#include "core/study/text/height_facts_text.h"
#include "core/study/text/terrain_text.h"
#include "tests/fuzz/fuzz_file.h"
#include "tests/fuzz/require.h"

namespace {

using noonmark::tests::require;

void readSettings(const std::string& text) {
    const auto settings = noonmark::readSettingsFrom(text);
    if (!settings) return;
    const std::string written = formatText(*settings);
    const auto again = noonmark::readSettingsFrom(written);
    require(again && formatText(*again) == written, "settings come back");
}

void readFacts(const std::string& text) {
    const auto facts = noonmark::parseHeightFacts(text);
    if (!facts) return;
    for (const auto& field : facts->fields) require(!describe(field).empty(), "a field has words");
    for (const auto& field : facts->unknown) require(!describe(field).empty(), "a field has words");
    const auto json = heightFactsJson(*facts);
    const auto again = noonmark::parseHeightFacts(json.dump());
    require(again && heightFactsJson(*again) == json, "height facts come back");
}

void readSource(const std::string& text) {
    noonmark::Terrain terrain{noonmark::PostGrid(0, 0, 1, 2, 2), std::vector<float>(4)};
    if (!noonmark::takeSource(text, terrain)) return;
    (void)noonmark::formatText(terrain);
    require(noonmark::takeSource(noonmark::sourceText(terrain), terrain), "a source comes back");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string text(noonmark::tests::formatText(data, size));
    readSettings(text);
    readFacts(text);
    readSource(text);
    return 0;
}
