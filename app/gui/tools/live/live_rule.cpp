#include "app/gui/tools/live/live_rule.h"

#include <QObject>

#include "app/gui/base/widgets/number_words.h"

namespace noonmark {

namespace {

QString describeStep(std::size_t steps) {
    return steps == 1 ? QObject::tr("this moment")
                      : QObject::tr("all %1 step(s)", "", pluralNumber(steps)).arg(formatCount(steps));
}

}  // namespace

std::vector<LiveEngine> liveEngines(const City& city, ReceiverPlaces places, std::size_t steps) {
    const bool level = !city.terrain && places == ReceiverPlaces::ground;
    if (!level) return {LiveEngine::horizons};
    if (steps <= LiveRule::maxSteps) return {LiveEngine::shadows, LiveEngine::horizons};
    return {LiveEngine::horizons, LiveEngine::moments};
}

QString describeExactness(LiveEngine engine, std::size_t counted, std::size_t steps, bool runs) {
    switch (engine) {
        case LiveEngine::shadows:
            return QObject::tr("exact at %1").arg(describeStep(steps));
        case LiveEngine::moments:
            return QObject::tr("exact at %1 of %2 step(s)", "", pluralNumber(steps))
                .arg(formatCount(counted), formatCount(steps));
        case LiveEngine::horizons:
            break;
    }
    const QString words = QObject::tr("%1, within 0.25° of azimuth").arg(describeStep(steps));
    return runs ? words : QObject::tr("%1; continuous shadow follows").arg(words);
}

}  // namespace noonmark
