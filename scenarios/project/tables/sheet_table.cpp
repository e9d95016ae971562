#include <fmt/format.h>

#include "core/describe/value_text.h"
#include "scenarios/project/read_project.h"
#include "scenarios/project/title_fields.h"
#include "scenarios/project/write_project.h"

// Reads and writes the table `sheet_settings`: what the project's sheets carry, and the units of its results.
namespace noonmark {

namespace {

constexpr const char* logoKey = "logo";

void readSetting(const Statement& row, SheetSettings& settings) {
    const std::string key = row.text(0);
    if (key == logoKey) settings.titleBlock.logo = row.blob(1);
    const Editable fields = sheetFields().of(settings);
    for (const Field& field : fields.fields)
        if (key == field.key && !fields.set(field, row.text(1)))
            throwDamaged(fmt::format("the {} of the sheets are unknown", key));
}

}  // namespace

void writeSheetSettings(Database& database, const SheetSettings& settings) {
    database.execute("DELETE FROM sheet_settings");
    Statement add = database.prepare("INSERT INTO sheet_settings (key, value) VALUES (?, ?)");
    for (const Field& field : sheetFields().rows())
        if (const std::string value = formatText(field.get(&settings)); !value.empty())
            add.run(field.key, value);
    if (!settings.titleBlock.logo.empty()) add.run(logoKey, AsBlob{settings.titleBlock.logo});
}

SheetSettings readSheetSettings(Database& database) {
    SheetSettings settings;
    Statement row = database.prepare("SELECT key, value FROM sheet_settings");
    while (row.step()) readSetting(row, settings);
    if (const auto sound = validate(settings.titleBlock); !sound) throwDamaged(sound.error().what);
    return settings;
}

}  // namespace noonmark
