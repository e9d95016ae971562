#include "app/window/study/run_estimate.h"

#include <QObject>
#include <algorithm>
#include <array>
#include <cmath>

#include "core/engines/auto_engine.h"
#include "core/receivers/roof_receivers.h"

namespace noonmark {

Result<RunEstimate> estimateRays(const City& city, const StudySettings& settings,
                                 const std::stop_token& stop) {
    const auto receivers = placeReceivers(city, settings.region, settings.receivers, stop);
    if (!receivers) return tl::make_unexpected(receivers.error());
    const auto sun = computeSunSteps(settings.period, makeObserver(city, settings), stop);
    if (!sun) return tl::make_unexpected(sun.error());
    const std::array cities{&city};
    const EngineLoad load = measureEngineLoad(cities, *receivers, *sun, HorizonSweepSettings());
    const EstimatedSeconds seconds = estimateSeconds(load);
    const double exact = load.level ? seconds.projected : seconds.ray;
    return RunEstimate{double(load.receivers) * double(load.steps), seconds.ray,
                       std::min(exact, seconds.horizon)};
}

QString describeAbout(double seconds) {
    struct Unit {
        double seconds;
        QString words;
    };
    const Unit units[] = {{86400, QObject::tr("days")},
                          {3600, QObject::tr("h")},
                          {60, QObject::tr("min")},
                          {1, QObject::tr("s")}};
    for (const Unit& unit : units)
        if (seconds >= 2 * unit.seconds)
            return QObject::tr("about %1 %2").arg(std::round(seconds / unit.seconds)).arg(unit.words);
    return QObject::tr("about a second");
}

}  // namespace noonmark
