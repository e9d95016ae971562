#include "app/gui/view/exploration/exploration.h"

#include <algorithm>
#include <cmath>

#include "app/gui/base/widgets/number_text.h"
#include "core/engines/ray/surface_rays.h"
#include "core/lab/accrual/surface_accrual.h"

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
    float maximum = 0;
    for (const float value : minutes)
        if (value > maximum) maximum = value;  // NaN never compares greater
    const double top = std::max(view.shadow.sunlitMinutesPerDay, double(maximum));
    return makeLegend(measure, choice, view.shadow.sunlitMinutesPerDay, top, minutes);
}

bool coversPart(const ExploredView& view) { return !view.running.empty() || view.daysShown < view.days; }

SurfacePicture surfacePicture(const ExploredView& view, ShadowMeasure measure, double top) {
    const std::vector<float>& minutes = minutesOf(view, measure);
    SurfacePicture picture;
    picture.camera = view.camera;
    picture.soFar = coversPart(view);
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
    if (!coversPart(view)) return detail;
    return QObject::tr("%1 of %2 day(s); %3", "", pluralNumber(quint64(view.days)))
        .arg(formatCount(quint64(view.daysShown)), formatCount(quint64(view.days)), detail);
}

Exploration::Exploration(QObject* parent) : QObject(parent) {
    connect(&slot_, &JobSlot::started, this, [this](const Job& job) {
        connect(&job, &Job::partial, this, [this](const auto& running) { takeRunning(*running); });
    });
    connect(&slot_, &JobSlot::ended, this, [this] { running_.reset(); });
}

void Exploration::setCity(std::shared_ptr<const OpenCity> city) {
    slot_.drop();
    answer_.reset();
    question_.city = std::move(city);
    question_.sun.reset();
    makeEngine();
    Q_EMIT changed();
    ask();
}

void Exploration::makeEngine() {
    if (byMaps_)
        engine_ = {SurfaceAccrual::make({}, {}).value(), false};
    else
        engine_ = {std::make_shared<SurfaceRays>(question_.city->picker.scene()), true};
}

void Exploration::setByMaps(bool maps) {
    if (byMaps_ == maps) return;
    byMaps_ = maps;
    slot_.drop();
    if (!question_.city) return;
    makeEngine();
    ask();
}

void Exploration::setPeriod(const Period& period, const Observer& observer) {
    if (question_.period == period && question_.observer == observer) return;
    question_.period = period;
    question_.observer = observer;
    question_.sun.reset();
    answer_.reset();
    slot_.drop();
    ask();
}

void Exploration::look(const CameraPose& pose, const ViewLens& lens,
                       const std::optional<SectionBox>& section) {
    if (question_.pose == pose && question_.lens == lens && question_.section == section) return;
    question_.section = section;
    question_.pose = pose;
    question_.lens = lens;
    waiting_ = true;
    if (!slot_.busy() || !fresh_) ask();
}

void Exploration::setActive(bool active) {
    if (active_ == active) return;
    active_ = active;
    if (!active) return slot_.drop();
    if (answer_ && !waiting_)
        refine();
    else
        ask();
}

bool Exploration::canAsk() const { return active_ && question_.city && question_.city->picker.scene(); }

void Exploration::ask() {
    if (!canAsk()) return;
    answer_.reset();
    running_.reset();
    refine();
}

void Exploration::refine() {
    if (!canAsk() || (answer_ && isFinest(*answer_))) return;
    fresh_ = !answer_;
    if (fresh_) waiting_ = false;
    slot_.start<ViewAnswer>(
        tr("Exploring"),
        [question = question_, before = answer_, engine = engine_](Progress& progress, std::stop_token stop) {
            return refineView(question, before.get(), engine, progress, std::move(stop));
        },
        [this](Result<ViewAnswer> answer) { take(std::move(answer)); });
}

void Exploration::take(Result<ViewAnswer> answer) {
    if (!answer) {
        Q_EMIT changed();
        if (!isCancelled(answer.error())) Q_EMIT failed(answer.error());
        return;
    }
    answer_ = std::make_shared<const ViewAnswer>(*std::move(answer));
    question_.sun = answer_->sun;
    if (engine_.inParts && answer_->turn.tests > 0) question_.turnTests = turnTestsAfter(*answer_);
    Q_EMIT changed();
    if (waiting_)
        ask();
    else
        refine();
}

void Exploration::takeRunning(const PartialField& running) {
    if (!answer_ || engine_.inParts) return;
    auto shown = withRunning(*answer_, running);
    if (!shown) return;
    running_ = std::make_shared<const ViewAnswer>(*std::move(shown));
    Q_EMIT changed();
}

}  // namespace noonmark
