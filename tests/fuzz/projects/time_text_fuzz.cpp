// Days, times, instants, solar windows and time-zone rules, as written by users and in files.
#include "core/sun/civil_time.h"
#include "core/sun/period.h"
#include "tests/fuzz/fuzz_file.h"
#include "tests/fuzz/require.h"

namespace {

using noonmark::tests::require;

void readTimes(std::string_view text) {
    if (const auto date = noonmark::parseDate(text))
        require(date->ok() && noonmark::parseDate(noonmark::formatText(*date)) == *date, "a date comes back");
    if (const auto time = noonmark::parseTimeOfDay(text))
        require(noonmark::parseTimeOfDay(noonmark::formatText(*time)) == *time, "a time of day comes back");
    if (const auto window = noonmark::parseSolarHours(text))
        require(noonmark::parseSolarHours(formatText(*window)) == *window, "a solar window comes back");
    (void)noonmark::parseInstant(text, noonmark::Zone::utc());
}

void readRule(std::string_view text) {
    const auto rule = noonmark::PosixRule::parsed(text);
    if (!rule) return;
    for (int hour = 0; hour < 366 * 24; hour += 999)
        require(std::chrono::abs(rule->offsetAt(std::chrono::sys_seconds(std::chrono::hours(hour)))) <=
                    std::chrono::hours(48),
                "an offset is less than two days");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string_view text = noonmark::tests::formatText(data, size);
    readTimes(text);
    readRule(text);
    return 0;
}
