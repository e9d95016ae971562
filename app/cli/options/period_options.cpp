#include "app/cli/options/period_options.h"

#include "app/cli/options/field_options.h"
#include "core/sun/period_fields.h"

namespace noonmark::cli {

CLI::Option* addPeriodOptions(CLI::App& command, PeriodOptions& options) {
    addFieldOptions(command, periodFields().of(options.period),
                    {.names = options.names, .given = &options.given});
    return command.get_option("--start");
}

Result<Period> periodFrom(const PeriodOptions& options) {
    // With hours of the sun the zone only says where a date begins.
    if (!options.states("--zone") && !options.period.window)
        return failure("The hours need a time zone", "period",
                       "Give --zone, for example --zone America/New_York");
    return Zone::named(options.period.zone).and_then([&](const Zone& zone) {
        Period period = options.period;
        period.zone = zone.name();
        return validate(period);
    });
}

}  // namespace noonmark::cli
