#include "core/study/repeat_command.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <string_view>
#include <vector>

#include "core/receivers/roof_receivers.h"
#include "core/study/region_text.h"

namespace noonmark {

namespace {

/// As it is when a shell can't misread it, else in single quotes.
std::string quoted(const std::string& text) {
    const auto harmless = [](unsigned char c) {
        return std::isalnum(c) != 0 || c > 127 ||
               std::string_view("-_./,:+@%=").find(char(c)) != std::string_view::npos;
    };
    if (!text.empty() && std::ranges::all_of(text, harmless)) return text;
    std::string result = "'";
    for (const char c : text) result += c == '\'' ? std::string("'\\''") : std::string(1, c);
    return result + "'";
}

/// Collects options; those that equal the default are left out.
class CommandLine {
public:
    explicit CommandLine(std::string program) : pieces_{std::move(program)} {}
    void file(const std::string& name) {
        pieces_.push_back(quoted(name.starts_with('-') ? "./" + name : name));
    }
    void option(const char* name, const std::string& value) {
        pieces_.push_back(fmt::format("{} {}", name, quoted(value)));
    }
    void unless(bool isDefault, const char* name, const std::string& value) {
        if (!isDefault) option(name, value);
    }
    void flag(bool set, const char* name) {
        if (set) pieces_.emplace_back(name);
    }

    /// Lines end between pieces, with a backslash.
    [[nodiscard]] std::string wrapped(std::size_t width) const {
        std::string text;
        std::size_t used = 0;
        for (const std::string& piece : pieces_) {
            const bool breaks = used > 0 && used + 1 + piece.size() + 2 > width;
            if (used > 0) text += breaks ? " \\\n    " : " ";
            used = (breaks ? 4 : used + (used > 0 ? 1 : 0)) + piece.size();
            text += piece;
        }
        return text;
    }

private:
    std::vector<std::string> pieces_;
};

std::string nameOf(LengthUnit unit) {
    switch (unit) {
        case LengthUnit::metres:
            return "m";
        case LengthUnit::feet:
            return "ft";
        case LengthUnit::usSurveyFeet:
            return "us-ft";
        case LengthUnit::centimetres:
            return "cm";
    }
    return "m";
}

std::string nameOf(TerrainFromBases choice) {
    return choice == TerrainFromBases::always  ? "always"
           : choice == TerrainFromBases::never ? "never"
                                               : "auto";
}

void addReading(CommandLine& line, const ReadSettings& reading) {
    const ReadSettings usual;
    line.unless(reading.heightField.empty(), "--height-field", reading.heightField);
    line.unless(reading.levelsField.empty(), "--levels-field", reading.levelsField);
    if (reading.heightUnit) line.option("--height-unit", nameOf(*reading.heightUnit));
    line.unless(reading.metresPerLevel == usual.metresPerLevel, "--metres-per-level",
                fmt::to_string(reading.metresPerLevel));
    line.unless(reading.defaultHeightM == usual.defaultHeightM, "--default-height",
                fmt::to_string(reading.defaultHeightM));
    line.unless(reading.layer.empty(), "--layer", reading.layer);
    if (reading.crs) line.option("--crs", *reading.crs);
    line.unless(reading.lod.empty(), "--lod", reading.lod);
    line.unless(reading.terrainFromBases == usual.terrainFromBases, "--terrain-from-bases",
                nameOf(reading.terrainFromBases));
    line.unless(reading.farAwayM == usual.farAwayM, "--far-away", fmt::to_string(reading.farAwayM));
}

void addMesh(CommandLine& line, const ReadSettings& reading) {
    line.unless(reading.upAxis == UpAxis::y, "--up", "z");
    line.unless(reading.meshUnit == LengthUnit::metres, "--mesh-unit", nameOf(reading.meshUnit));
    line.unless(reading.meshNorthDeg == 0, "--mesh-north", fmt::to_string(reading.meshNorthDeg));
    if (reading.meshAnchor)
        line.option("--mesh-anchor",
                    fmt::format("{},{}", reading.meshAnchor->lonDeg, reading.meshAnchor->latDeg));
}

std::string windowText(const SolarWindow& window) {
    const auto minutes = [](const char* event, long later) { return fmt::format("{}{:+}m", event, later); };
    return minutes("sunrise", long(window.afterSunrise.count())) + ".." +
           minutes("sunset", -long(window.beforeSunset.count()));
}

void addPeriod(CommandLine& line, const Period& period) {
    line.option("--start", fmt::format("{:04}-{:02}-{:02}", int(period.start.year()),
                                       unsigned(period.start.month()), unsigned(period.start.day())));
    line.option("--days", fmt::to_string(period.days));
    if (period.window) {
        line.option("--window", windowText(*period.window));
        line.flag(period.window->rule == SunriseRule::centre, "--centre");
    } else {
        line.option("--from", fmt::format("{:02}:{:02}", period.from.count() / 60, period.from.count() % 60));
        line.option("--hours", fmt::to_string(period.hours));
    }
    line.option("--step", fmt::format("{}", period.stepMinutes));
    line.option("--zone", period.zone);
    line.flag(!period.refraction, "--no-refraction");
}

// The one that was picked, unless its options or what is asked of it are not for it.
std::string engineToName(const Study& study) {
    const StudySettings& settings = study.settings;
    const bool plain = settings.engineSettings.empty() && !settings.byMonth && !settings.contributions;
    return plain && !study.field.engineKey.empty() ? study.field.engineKey : settings.engine;
}

void addSettings(CommandLine& line, const Study& study) {
    const StudySettings& settings = study.settings;
    const StudySettings usual;
    line.unless(settings.pressureHPa == usual.pressureHPa, "--pressure",
                fmt::to_string(settings.pressureHPa));
    line.unless(settings.temperatureC == usual.temperatureC, "--temperature",
                fmt::to_string(settings.temperatureC));
    line.option("--region", boxTextOf(settings.region, study.city.frame).value_or(regionFileName));
    line.option("--cell", fmt::format("{}", study.field.grid.cellM));
    line.unless(settings.receivers.places == usual.receivers.places, "--receivers",
                std::string(nameOf(settings.receivers.places)));
    line.option("--engine", engineToName(study));
    for (const auto& [key, value] : settings.engineSettings)
        line.option("--option", fmt::format("{}={}", key, value));
    if (settings.byMonth) line.option("--by", "month");
    line.flag(settings.contributions, "--contributions");
    line.unless(settings.errorSample.receivers == usual.errorSample.receivers, "--error-sample",
                fmt::to_string(settings.errorSample.receivers));
}

/// Read because another file needs it: not named on the command line.
bool goesAlong(const std::filesystem::path& file) {
    static constexpr std::array<std::string_view, 6> extensions{".dbf", ".shx", ".prj",
                                                                ".cpg", ".bin", ".tfw"};
    return std::ranges::find(extensions, file.extension().string()) != extensions.end();
}

}  // namespace

std::string repeatCommand(const Study& study, std::size_t width, const std::string& command) {
    CommandLine line("noonmark-cli " + command);
    for (const InputFile& input : study.inputs)
        if (!goesAlong(input.path)) line.file(input.path.filename().string());
    if (study.inputs.empty()) line.file("FILE");
    addReading(line, study.reading);
    addMesh(line, study.reading);
    addPeriod(line, study.settings.period);
    addSettings(line, study);
    line.option("--out", "repeated");
    return line.wrapped(width);
}

}  // namespace noonmark
