#include "core/describe/field.h"
#include "core/describe/text.h"
#include "core/study/by_place/sun_by_place.h"

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
               .help = NM_TEXT("Size of the cells of places with fewer than 25 cells, m; as large as the "
                               "others or larger: the same"),
               .unit = "m",
               .range = ValueRange{ReceiverSettings::minCellM, ReceiverSettings::maxCellM}}),
    };
    return fields;
}

}  // namespace noonmark
