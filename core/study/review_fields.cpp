#include "core/study/review_study.h"
#include "core/study/study_fields.h"

namespace noonmark {

const Fields<ReviewSettings>& reviewFields() {
    static const Fields<ReviewSettings> fields{
        field(&ReviewSettings::year, {.key = "year",
                                      .flag = "--year",
                                      .label = "Year",
                                      .help = "Year of the days (default: that of the first period, or 2026)",
                                      .hint = "YEAR",
                                      .range = ValueRange{1901, 2099},
                                      .restated = true}),
        field(&ReviewSettings::zone, {.key = "zone",
                                      .flag = "--zone",
                                      .label = "Time zone",
                                      .help = "Time zone (default: that of the project's periods)",
                                      .hint = "ZONE",
                                      .entry = TextEntry::zone,
                                      .restated = true}),
        field(&ReviewSettings::cellM, cellSizeFacts())};
    return fields;
}

}  // namespace noonmark
