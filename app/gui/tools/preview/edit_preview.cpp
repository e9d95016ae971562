#include "app/gui/tools/preview/edit_preview.h"

#include <QStringList>
#include <algorithm>

#include "app/gui/base/widgets/error_text.h"
#include "app/gui/base/widgets/number_text.h"
#include "app/gui/session/study/open_city.h"
#include "app/gui/session/study/region_text.h"
#include "app/gui/view/panel/view_panel.h"
#include "app/report/maps/answer_legends.h"
#include "scenarios/massing/tower_design.h"

namespace noonmark {

namespace {

constexpr std::size_t maxPlaces = 4;

QString minutesOf(double minutes) { return groupDigits(minutes, minutes < 10 ? 1 : 0); }

// "1,230 m² over 30 min"
QString overThreshold(double areaM2, double thresholdMin) {
    return QObject::tr("%1 over %2 min").arg(describeSmallArea(areaM2), minutesOf(thresholdMin));
}

QString describeNewShadow(const LiveChange& change) {
    if (change.figures.front().gross.anyMoreShadowM2 == 0) return QObject::tr("No new shadow");
    if (isInstant(change.impact))
        return QObject::tr("New shadow: %1")
            .arg(describeSmallArea(change.figures.front().gross.anyMoreShadowM2));
    QStringList areas;
    for (const ImpactFigures& figures : change.figures)
        areas << overThreshold(figures.gross.moreShadowM2, figures.thresholdMin);
    // A comparison on other cells finds an area that differs by a part of the cells at the shadow's edge.
    return QObject::tr("New shadow a day, by cells of %1: %2")
        .arg(describeLength(change.impact.grid.cellM), areas.join(QStringLiteral(", ")));
}

QString describeWorst(const LiveChange& change) {
    return QObject::tr("Worst spot: +%1 min a day")
        .arg(minutesOf(change.figures.front().gross.maxMoreShadowMin));
}

QString describeLess(const LiveChange& change) {
    const ImpactFigures& figures = change.figures.front();
    if (isInstant(change.impact))
        return QObject::tr("Less shadow: %1").arg(describeSmallArea(figures.gross.anyLessShadowM2));
    return QObject::tr("Less shadow a day: %1")
        .arg(overThreshold(figures.gross.lessShadowM2, figures.thresholdMin));
}

QString describePlace(const PlaceChange& place, bool instant) {
    const ChangeFigures& gross = place.figures.gross;
    const QString name = placeName(place.name);
    QString words = instant ? QObject::tr("%1: %2").arg(name, describeSmallArea(gross.anyMoreShadowM2))
                            : QObject::tr("%1: %2, up to +%3 min")
                                  .arg(name, overThreshold(gross.moreShadowM2, place.figures.thresholdMin),
                                       minutesOf(gross.maxMoreShadowMin));
    if (!place.whole) words += QObject::tr(" (of the part that is measured)");
    return words;
}

}  // namespace

QString describeEffect(const LiveChange& change, const QString& verdicts) {
    const bool instant = isInstant(change.impact);
    QStringList lines{describeNewShadow(change)};
    if (!instant && change.worst) lines << describeWorst(change);
    if (change.figures.front().gross.anyLessShadowM2 > 0) lines << describeLess(change);
    const std::size_t shown = std::min(change.places.size(), maxPlaces);
    for (std::size_t i = 0; i < shown; ++i) lines << describePlace(change.places[i], instant);
    if (const std::size_t more = change.places.size() - shown; more > 0)
        lines << QObject::tr("and %1 more place(s)", "", pluralNumber(more)).arg(formatCount(more));
    if (change.reachesBeyond) lines << QObject::tr("The change reaches beyond the ground that is measured");
    if (!verdicts.isEmpty()) lines << verdicts;
    return lines.join(u'\n');
}

namespace {

using Buildings = std::vector<std::shared_ptr<const Building>>;

// Half width of the square of the live shadow, metres: about the part of the ground that is visible.
double halfWidthM(const CameraPose& pose) { return std::clamp(0.6 * pose.distanceM, 150.0, 1000.0); }

City without(const City& city, const Buildings& removed) {
    City rest = city;
    std::erase_if(rest.buildings, [&](const auto& building) {
        return std::ranges::find(removed, building) != removed.end();
    });
    return rest;
}

QString describe(const LiveAnswer& live) {
    return describeExactness(live.engine, live.counted, live.steps, live.runs);
}

GroundAnswer makeLiveAnswer(const std::shared_ptr<const LiveAnswer>& live) {
    return {std::shared_ptr<const ShadowField>(live, &live->field),
            std::shared_ptr<const Receivers>(live, &live->receivers),
            QObject::tr("With the proposal: %1").arg(describe(*live)), false, !live->runs};
}

// `live` must have a change.
GroundAnswer makeChangeAnswer(const std::shared_ptr<const LiveAnswer>& live, const std::string& baseline) {
    return {std::shared_ptr<const Impact>(live, &live->change->impact), nullptr,
            QObject::tr("Change by the proposal, compared with %1: %2")
                .arg(QString::fromStdString(baseline), describe(*live)),
            false, !live->runs};
}

}  // namespace

EditPreview::EditPreview(ViewPanel& panel, std::shared_ptr<SharedHorizonCache> horizons, QObject* parent)
    : QObject(parent), panel_(panel), live_(std::move(horizons)) {
    connect(&live_, &LiveFollower::changed, this, &EditPreview::showLive);
    connect(&live_, &LiveFollower::aged, this, &EditPreview::showAge);
    connect(&live_, &LiveFollower::failed, this, &EditPreview::showReason);
    connect(&facades_, &LiveFacades::changed, this, &EditPreview::showLiveFacades);
    connect(&facades_, &LiveFacades::failed, this, [this](const Error& error) {
        panel_.results().setLiveFacades(std::nullopt);
        if (!isCancelled(error)) Q_EMIT hinted(tr("No live facades. %1").arg(describeError(error)));
    });
}

void EditPreview::setCity(std::shared_ptr<const OpenCity> city) {
    city_ = std::move(city);  // ending the preview must restore the new city's buildings
    clear();
}

void EditPreview::setQuestion(const LiveQuestion& question) {
    if (question_ == question) return;
    question_ = question;
    if (!shown_) return;
    begin();
    live_.follow(changes_.added);
    followFacades();
}

void EditPreview::setBaseline(std::shared_ptr<const City> city, const std::string& scenario) {
    const bool another = city != baseline_;
    baseline_ = std::move(city);
    baselineName_ = scenario;
    if (!another || !shown_) return;
    begin();
    live_.follow(changes_.added);
    followFacades();
}

void EditPreview::showChange(bool shown) {
    changeShown_ = shown;
    if (!shown_) return;
    beginFacades();
    followFacades();
    if (live_.answer()) showLive();
}

void EditPreview::setVerdicts(const QString& words) {
    if (words == verdicts_) return;
    verdicts_ = words;
    if (shown_) showEffect();
}

void EditPreview::setFacades(const FacadeSettings& facades) {
    if (facadeSettings_ == facades) return;
    facadeSettings_ = facades;
    beginFacades();
    followFacades();
}

void EditPreview::showFacades(bool shown) {
    facadesShown_ = shown;
    beginFacades();
    followFacades();
}

void EditPreview::toggleNeighbour(const std::shared_ptr<const Building>& building) {
    const auto found = std::ranges::find(neighbours_, building);
    found == neighbours_.end() ? neighbours_.push_back(building) : void(neighbours_.erase(found));
    followFacades();
}

Result<void> EditPreview::show(const std::vector<Edit>& edits) {
    if (!city_) return {};
    auto edited = applyEdits(city_->city(), edits);
    if (!edited) return tl::make_unexpected(edited.error());
    const bool before = shown_;
    const bool others = !shown_ || changes_.removed != edited->changes.removed;
    changes_ = std::move(edited->changes);
    storeys_.clear();
    for (const auto& [id, tower] : findProposedTowers(edits))
        if (tower.storeyHeightM > 0) storeys_[id] = tower.storeyHeightM;
    shown_ = true;
    City proposed;
    proposed.buildings = changes_.added;
    panel_.view().overlay().show(OverlayBodies::Tint::proposed, proposed);
    if (others) {
        hide(changes_.removed);
        begin();
    }
    live_.follow(changes_.added);
    followFacades();
    if (!before) Q_EMIT shownChanged(true);
    Q_EMIT shapeChanged(std::make_shared<const City>(std::move(edited->city)));
    return {};
}

void EditPreview::clear() {
    if (!shown_) return;
    shown_ = false;
    changes_ = {};
    live_.end();
    facades_.end();
    neighbours_.clear();
    panel_.results().setLiveFacades(std::nullopt);
    panel_.view().overlay().show(OverlayBodies::Tint::proposed, {});
    panel_.results().setLive(std::nullopt);
    panel_.view().overlay().showWorstSpot(std::nullopt);
    hide({});
    Q_EMIT effectChanged({});
    Q_EMIT shownChanged(false);
    Q_EMIT shapeChanged(nullptr);
}

void EditPreview::hide(const Buildings& removed) {
    panel_.view().showChanges(computeDifference(*city_->arrays, without(city_->city(), removed)));
}

void EditPreview::begin() {
    const ChangedVolume volume = computeVolume(changes_);
    beginFacades();
    live_.end();
    panel_.view().overlay().showWorstSpot(std::nullopt);
    showEffect();
    if (volume.box.empty()) return;
    live_.begin(
        {without(city_->city(), changes_.removed), volume, halfWidthM(panel_.view().pose()), baseline_},
        question_);
}

bool EditPreview::showsChange() const {
    return changeShown_ && baseline_ && question_.receivers.places != ReceiverPlaces::roofs;
}

// Nothing is measured where nothing is built. Sunlight of facades has no place in the scale of a change.
void EditPreview::beginFacades() {
    facades_.end();
    panel_.results().setLiveFacades(std::nullopt);
    if (!shown_ || !facadesShown_ || showsChange() || changes_.added.empty()) return;
    facades_.begin(without(city_->city(), changes_.removed), question_.sun, facadeSettings_);
}

void EditPreview::followFacades() {
    if (shown_) facades_.follow(changes_.added, neighbours_, storeys_);
}

void EditPreview::showLiveFacades() {
    const auto answer = facades_.answer();
    const std::size_t points = answer->map.elements.size();
    const int form = pluralNumber(points);
    const QString note = answer->coarse ? tr("Facades: %1 point(s) while it moves", "", form)
                                        : tr("Facades: %1 point(s)", "", form);
    panel_.results().setLiveFacades(
        ElementView{std::shared_ptr<const ElementMap>(answer, &answer->map), note.arg(formatCount(points))});
}

GroundAnswer EditPreview::makeLiveAnswer() const {
    const auto answer = live_.answer();
    GroundAnswer shown = showsChange() && answer->change ? makeChangeAnswer(answer, baselineName_)
                                                         : noonmark::makeLiveAnswer(answer);
    shown.when = describeWhen(question_.sun.period);
    return shown;
}

void EditPreview::showLive() {
    panel_.results().setLive(makeLiveAnswer());
    const LiveAnswer& answer = *live_.answer();
    const bool marked = showsChange() && answer.change && answer.change->worst;
    panel_.view().overlay().showWorstSpot(
        marked ? std::optional(glm::dvec3(answer.receivers.position(*answer.change->worst))) : std::nullopt);
    showEffect();
}

void EditPreview::showEffect() {
    const auto answer = live_.answer();
    Q_EMIT effectChanged(answer && answer->change ? describeEffect(*answer->change, verdicts_) : verdicts_);
}

void EditPreview::showAge() {
    Q_EMIT effectAged();
    const auto answer = makeLiveAnswer();
    panel_.results().noteLive(
        tr("%1. Shape of %2 s ago").arg(answer.note, groupDigits(live_.ageSeconds(), 1)));
}

// Without a live shadow only the buildings are shown.
void EditPreview::showReason(const Error& error) {
    panel_.results().setLive(std::nullopt);
    panel_.view().overlay().showWorstSpot(std::nullopt);
    showEffect();
    Q_EMIT hinted(isCancelled(error) ? tr("The live shadow was cancelled; it returns with the next design")
                                     : tr("No live shadow. %1").arg(describeError(error)));
}

}  // namespace noonmark
