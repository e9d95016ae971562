#include "app/gui/view/exploration/explored_picture.h"

#include "app/gui/base/widgets/number_words.h"

#include <QObject>
#include <algorithm>
#include <cmath>

namespace noonmark {

namespace {

const std::vector<float>& minutesOf(const ExploredView& view, ShadowMeasure measure) {
    return measure == ShadowMeasure::gross ? view.shadow.grossMin : view.shadow.continuousMin;
}

QString describeMethod(const std::string& engine) {
    return engine.starts_with("Ray") ? QObject::tr("by rays") : QObject::tr("by shadow accrual maps");
}

bool isInstant(const ExploredView& view) { return view.days == 1 && view.shadow.sunlitMinutesPerDay <= 1; }

}  // namespace

Legend makeLegend(const ExploredView& view, ShadowMeasure measure, const LegendChoice& choice) {
    if (isInstant(view)) return momentLegend();
    const std::vector<float>& minutes = minutesOf(view, measure);
    float most = 0;
    for (const float value : minutes)
        if (value > most) most = value;  // NaN never compares greater
    const double top = std::max(view.shadow.sunlitMinutesPerDay, double(most));
    return makeLegend(measure, choice, view.shadow.sunlitMinutesPerDay, top, minutes);
}

bool isSoFar(const ExploredView& view) { return !view.running.empty() || view.daysShown < view.days; }

SurfacePicture surfacePicture(const ExploredView& view, ShadowMeasure measure, double top) {
    const std::vector<float>& minutes = minutesOf(view, measure);
    SurfacePicture picture;
    picture.camera = view.camera;
    picture.soFar = isSoFar(view);
    const std::size_t pixels = std::size_t(view.camera.widthPx) * std::size_t(view.camera.heightPx);
    picture.samples.assign(pixels, {0, 0, 0, -1});
    const VisibleSurface& surface = *view.surface;
    for (std::size_t point = 0; point < surface.pixel.size(); ++point) {
        if (std::isnan(minutes[point])) continue;
        const float share = std::clamp(float(double(minutes[point]) / top), 0.0F, 1.0F);
        picture.samples[surface.pixel[point]] = {surface.points.positions[point], share};
    }
    return picture;
}

QString describeDetail(const ExploredView& view, double distanceM) {
    const QString samples = view.spacingPx == 1
                                ? QObject::tr("every pixel")
                                : QObject::tr("a sample every %1 pixel(s)", "", view.spacingPx)
                                      .arg(formatCount(quint64(view.spacingPx)));
    const QString detail =
        QObject::tr("%1, %2 m, %3")
            .arg(samples, formatShort(view.sampleM(distanceM), 2), describeMethod(view.shadow.engine));
    if (!view.running.empty())
        return QObject::tr("%1; %2").arg(QString::fromStdString(view.running)).arg(detail);
    if (!isSoFar(view)) return detail;
    return QObject::tr("%1 of %2 day(s); %3", "", pluralNumber(quint64(view.days)))
        .arg(formatCount(quint64(view.daysShown)), formatCount(quint64(view.days)), detail);
}

}  // namespace noonmark
