#include <array>
#include <map>
#include <utility>

#include "core/io/settings/read_settings_text.h"
#include "core/study/text/height_facts_json.h"
#include "scenarios/project/read_project.h"
#include "scenarios/project/write_project.h"

// Reads and writes how the city was read: the tables `warning_texts` and `warnings`, and the rows
// `read_settings` and `height_fields` of the table `noonmark`.
namespace noonmark {

namespace {

constexpr const char* settingsKey = "read_settings";
constexpr const char* heightsKey = "height_fields";
constexpr std::array warningKinds{WarningKind::repaired, WarningKind::clipped, WarningKind::dropped,
                                  WarningKind::leftOut, WarningKind::assumed};

// As a project file names the kind. Files of all versions say "mended" for what was repaired.
std::string_view storedNameOf(WarningKind kind) {
    return kind == WarningKind::repaired ? "mended" : nameOf(kind);
}

// Number of a text in warning_texts; new texts are added.
class WarningTexts {
public:
    explicit WarningTexts(Database& database)
        : database_(database),
          add_(database.prepare("INSERT INTO warning_texts (kind, what) VALUES (?, ?)")) {}

    std::int64_t numberOf(const Warning& warning) {
        const auto [place, isNew] = numbers_.try_emplace({warning.kind, warning.what}, 0);
        if (isNew) {
            add_.run(storedNameOf(warning.kind), warning.what);
            place->second = database_.lastRow();
        }
        return place->second;
    }

private:
    Database& database_;
    Statement add_;
    std::map<std::pair<WarningKind, std::string>, std::int64_t> numbers_;
};

void writeSettings(Database& database, const std::optional<ReadSettings>& settings) {
    if (!settings) return removeFact(database, settingsKey);
    const std::string text = formatText(*settings);
    setFact(database, settingsKey, text.empty() ? "{}" : text);
}

std::optional<ReadSettings> readSettings(Database& database) {
    const std::string text = readFact(database, settingsKey);
    if (text.empty()) return std::nullopt;
    auto settings = readSettingsFrom(text);
    if (!settings) throwDamaged("the settings of reading the city are invalid");
    return settings;
}

void writeHeights(Database& database, const HeightFacts& heights) {
    if (heights == HeightFacts{}) return removeFact(database, heightsKey);
    setFact(database, heightsKey,
            heightFactsJson(heights).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace));
}

HeightFacts readHeights(Database& database) {
    const std::string text = readFact(database, heightsKey);
    if (text.empty()) return {};
    auto heights = parseHeightFacts(text);
    if (!heights) throwDamaged("the height fields of the city are invalid");
    return *std::move(heights);
}

WarningKind warningKindOf(const std::string& name) {
    for (const WarningKind kind : warningKinds)
        if (name == storedNameOf(kind)) return kind;
    throwDamaged("a warning is of an unknown kind");
}

}  // namespace

void writeReading(Database& database, const CityReading& reading) {
    writeSettings(database, reading.settings);
    writeHeights(database, reading.heights);
    database.execute("DELETE FROM warnings; DELETE FROM warning_texts;");
    WarningTexts texts(database);
    Statement add = database.prepare("INSERT INTO warnings (text, place) VALUES (?, ?)");
    for (const Warning& warning : reading.warnings) add.run(texts.numberOf(warning), warning.where);
}

std::shared_ptr<const CityReading> readReading(Database& database) {
    auto reading = std::make_shared<CityReading>();
    reading->settings = readSettings(database);
    reading->heights = readHeights(database);
    Statement row = database.prepare(
        "SELECT t.kind, t.what, w.place FROM warnings w LEFT JOIN warning_texts t ON t.id = w.text ORDER BY "
        "w.id");
    while (row.step()) reading->warnings.push_back({warningKindOf(row.text(0)), row.text(1), row.text(2)});
    return reading;
}

}  // namespace noonmark
