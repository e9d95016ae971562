#include "core/describe/command_options.h"
#include "core/describe/field.h"
#include "core/describe/text.h"
#include "core/study/by_place/sun_by_place.h"
#include "core/study/provenance/repeat_command.h"

namespace noonmark {

namespace {

Value getDates(const SunByPlaceSettings& settings) {
    std::vector<std::string> texts;
    for (const CivilDate& date : settings.dates) texts.push_back(formatText(date));
    return texts;
}

Result<void> setDates(SunByPlaceSettings& settings, const Value& value) {
    std::vector<CivilDate> dates;
    for (const std::string& text : std::get<std::vector<std::string>>(value)) {
        const auto date = parseDate(text);
        if (!date) return tl::make_unexpected(date.error());
        dates.push_back(*date);
    }
    settings.dates = std::move(dates);
    return {};
}

}  // namespace

const Fields<SunByPlaceSettings>& sunByPlaceFields() {
    static const Fields<SunByPlaceSettings> fields{
        field(&SunByPlaceSettings::enoughHours,
              {.key = "enough_hours",
               .flag = "--enough",
               .label = NM_TEXT("Enough sun"),
               .help = NM_TEXT(
                   "Hours of sun a day that are enough: the share of each place that has them is stated"),
               .hint = "H",
               .unit = "h",
               .range = ValueRange{0, SunByPlaceSettings::maxHours}}),
        derivedField<SunByPlaceSettings>(
            ValueKind::texts, getDates, setDates,
            {.key = "dates",
             .flag = "--date",
             .label = NM_TEXT("Dates"),
             .help = NM_TEXT("A day: the share of each place with less than enough sun on it is stated; may "
                             "be repeated"),
             .hint = "DATE"}),
        field(&SunByPlaceSettings::lossMin,
              {.key = "loss_min",
               .flag = "--loss",
               .label = NM_TEXT("Loss that counts"),
               .help = NM_TEXT("Minutes of sun a day: the share of each place that loses more is stated"),
               .hint = "MIN",
               .unit = "min",
               .range = ValueRange{0, SunByPlaceSettings::maxLossMin}}),
        field(&SunByPlaceSettings::smallCellM,
              {.key = "small_cell_m",
               .flag = "--small-cell",
               .label = NM_TEXT("Cells of small places"),
               .help = NM_TEXT("Size of the cells of places with fewer than 25 cells, m; no effect if it is "
                               "not smaller than that of the others"),
               .unit = "m",
               .range = ValueRange{ReceiverSettings::minCellM, ReceiverSettings::maxCellM}}),
    };
    return fields;
}

namespace {

void append(std::vector<CommandOption>& options, const std::vector<CommandOption>& more) {
    options.insert(options.end(), more.begin(), more.end());
}

// The scenarios of a project; one that was measured alone is the baseline of the command.
std::vector<CommandOption> listCities(const SunByPlace& sun, std::span<const ComparedSun> compared) {
    std::vector<CommandOption> options{{flags::baseline, {sun.name}}};
    for (const ComparedSun& one : compared) options.push_back({flags::scenario, {one.sun.name}});
    return options;
}

}  // namespace

Result<std::string> makeRepeatCommand(const SunByPlace& sun, std::span<const ComparedSun> compared,
                                      std::size_t width) {
    if (!sun.asked)
        return failure("No command can repeat this result: how its places were chosen is not known", {}, {});
    RepeatQuestion question{"by-place", sun.settings.study, sun.provenance, {}};
    question.settings.byMonth = question.settings.contributions = false;
    question.needsProject = sun.asked->ofProject || !compared.empty();
    question.namesCity = false;
    const bool namesProject = sun.provenance.project && sun.provenance.project->saved();
    if (namesProject) append(question.options, listCities(sun, compared));
    append(question.options, sun.asked->options);
    append(question.options, listOptions(sunByPlaceFields().of(sun.settings)));
    return makeRepeatCommand(question, width);
}

}  // namespace noonmark
