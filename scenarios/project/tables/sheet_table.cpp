#include "core/describe/value_text.h"
#include "scenarios/project/read_project.h"
#include "scenarios/project/title_fields.h"
#include "scenarios/project/write_project.h"

// Reads and writes the table `sheet_settings`: what the project's sheets carry, and the units of its results.
namespace noonmark {

namespace {

constexpr const char* unitsKey = "units";
constexpr const char* logoKey = "logo";
void readSetting(const Statement& row, SheetSettings& settings) {
    const std::string key = row.text(0);
    for (const Field& field : titleFields().rows())
        if (key == field.key) (void)field.set(&settings.titleBlock, row.text(1));
    if (key == logoKey) settings.titleBlock.logo = row.blob(1);
    if (key != unitsKey) return;
    const auto units = parseUnitSystem(row.text(1));
    if (!units) throwDamaged("the units of the sheets are unknown");
    settings.units = *units;
}

}  // namespace

void writeSheetSettings(Database& database, const SheetSettings& settings) {
    database.execute("DELETE FROM sheet_settings");
    Statement add = database.prepare("INSERT INTO sheet_settings (key, value) VALUES (?, ?)");
    for (const Field& field : titleFields().rows())
        if (const std::string value = formatText(field.get(&settings.titleBlock)); !value.empty())
            add.run(field.key, value);
    if (!settings.titleBlock.logo.empty()) add.run(logoKey, AsBlob{settings.titleBlock.logo});
    add.run(unitsKey, nameOf(settings.units));
}

SheetSettings readSheetSettings(Database& database) {
    SheetSettings settings;
    Statement row = database.prepare("SELECT key, value FROM sheet_settings");
    while (row.step()) readSetting(row, settings);
    if (const auto sound = validate(settings.titleBlock); !sound) throwDamaged(sound.error().what);
    return settings;
}

}  // namespace noonmark
