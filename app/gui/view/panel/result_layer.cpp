#include "app/gui/view/panel/result_layer.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <utility>

#include "app/gui/base/layers/field_picture.h"
#include "app/gui/base/layers/hover_text.h"
#include "app/gui/view/exploration/exploration.h"

namespace noonmark {

namespace {

// Cached horizons give no continuous shadow here.
GroundAnswer makeTimeAnswer(const std::shared_ptr<const TimeAnswer>& time) {
    return {std::shared_ptr<const ShadowField>(time, &time->field),
            std::shared_ptr<const Receivers>(time, &time->study->receivers), describe(time->look), false,
            true};
}

QString makeNote(const ViewAnswer& answer, double distanceM) {
    const QString words = describeDetail(answer.view, distanceM);
    if (coversPart(answer.view)) return QObject::tr("So far: %1").arg(words);
    return !isFinest(answer) ? QObject::tr("Refining: %1").arg(words) : words;
}

// Minutes of the last colour: those of the sunlit time, which no gross shadow exceeds, or the scale's end.
double topMinOf(const Legend& legend) {
    const ColourScale scale = coloursOf(legend);
    return std::max(scale.quantity.isSun() ? scale.quantity.sunlitMin : scale.high, 1e-9);
}

QString hintOf(ViewMode mode) {
    if (mode == ViewMode::exploration) return QObject::tr("Computing the shadow in the view...");
    return QObject::tr("No study yet: choose a period and a region, then press Run (Ctrl+R)");
}

}  // namespace

ResultLayer::ResultLayer(CityView& view, LegendStrip& legend) : view_(view), strip_(legend) { showNothing(); }

void ResultLayer::forget() {
    study_.reset();
    inFront_.reset();
    elements_.reset();
    places_.reset();
    verdicts_.reset();
    partial_.reset();
    time_.reset();
    explored_.reset();
    show();
}

void ResultLayer::setMode(ViewMode mode) {
    mode_ = mode;
    show();
}

void ResultLayer::setAnswer(std::optional<AnswerLayer> answer, bool isStudy) {
    study_.reset();
    inFront_.reset();
    elements_.reset();
    partial_.reset();
    if (answer && std::holds_alternative<ElementView>(*answer))
        elements_ = std::get<ElementView>(*std::move(answer));
    else if (answer)
        (isStudy ? study_ : inFront_) = std::get<GroundAnswer>(*std::move(answer));
    if (mode_ != ViewMode::exploration) show();
}

void ResultLayer::setTiles(std::shared_ptr<const TileView> tiles) {
    if (tiles == tiles_) return;
    tiles_ = std::move(tiles);
    show();
}

void ResultLayer::noteTiles(const QString& note, bool marked) {
    if (note == tileNote_ && marked == tileNoteMarked_) return;
    tileNote_ = note;
    tileNoteMarked_ = marked;
    if (showsTiles()) strip_.setNote(tileNote_, tileNoteMarked_);
}

void ResultLayer::setPartial(std::shared_ptr<const PartialField> partial) {
    if (!partial && !partial_) return;
    partial_ = partial ? std::optional(makeGroundAnswer(partial)) : std::nullopt;
    if (mode_ != ViewMode::exploration) show();
}

void ResultLayer::setTime(const std::shared_ptr<const TimeAnswer>& answer) {
    if (!answer && !time_) return;
    time_ = answer ? std::optional(makeTimeAnswer(answer)) : std::nullopt;
    if (mode_ != ViewMode::exploration) show();
}

void ResultLayer::setMoment(const QString& words, bool coversTiles) {
    if (words == moment_ && coversTiles == momentCovers_) return;
    moment_ = words;
    momentCovers_ = coversTiles;
    show();
}

void ResultLayer::setExplored(std::shared_ptr<const ViewAnswer> answer) {
    explored_ = std::move(answer);
    if (mode_ == ViewMode::exploration) show();
}

void ResultLayer::setLive(std::optional<GroundAnswer> answer) {
    if (!answer && !live_) return;
    live_ = std::move(answer);
    show();
}

void ResultLayer::setLiveFacades(std::optional<ElementView> facades) {
    if (!facades && !facades_) return;
    facades_ = std::move(facades);
    show();
}

void ResultLayer::noteLive(const QString& note) {
    if (live_) strip_.setNote(note, true);
}

bool ResultLayer::showsExplored() const {
    return mode_ == ViewMode::exploration && moment_.isEmpty() && !live_ && !showsTiles() && explored_;
}

bool ResultLayer::showsAnswer() const {
    return mode_ != ViewMode::exploration && moment_.isEmpty() && !showsTiles() && !showsVerdicts() &&
           !showsPlaces() && !showsElements() && !live_ && !partial_ && !time_;
}

void ResultLayer::show() {
    showCurrent();
    if (whenShown_) whenShown_();
}

void ResultLayer::showCurrent() {
    if (sides_) view_.other().clearPicture();
    if (showsTiles()) return showTiles();
    painted_.reset();
    if (shownElements() == nullptr) view_.tiles().clear();
    if (!moment_.isEmpty() && !live_ && !(time_ && mode_ != ViewMode::exploration)) return showMoment();
    if (mode_ == ViewMode::exploration && !live_) {
        view_.clearPicture();
        return explored_ ? showExplored() : showNothing();
    }
    view_.surfaces().clear();
    if (showsVerdicts()) return showPlaces(*verdicts_);
    if (showsElements()) return showElements();
    if (showsPlaces()) return sides_ ? showPlacesOfSides() : showPlaces(*places_);
    ground() || otherGround() ? showGround() : showNothing();
}

// Null: none. Facades of an edited building come with its live shadow.
const ElementMap* ResultLayer::shownElements() const {
    if (live_) return facades_ ? facades_->map.get() : nullptr;
    return showsElements() ? elements_->map.get() : nullptr;
}

bool ResultLayer::showsElements() const {
    return elements_ && !showsTiles() && !showsVerdicts() && !live_ && !partial_ &&
           mode_ != ViewMode::exploration && moment_.isEmpty();
}

void ResultLayer::showElements() {
    view_.clearPicture();
    const Legend legend = makeLegend(*elements_->map, strip_.measure(), strip_.choice());
    view_.tiles().show(makeTiles(*elements_->map, strip_.measure(), coloursOf(legend)));
    strip_.setLegend(legend);
    const bool ofRuns = strip_.measure() == ShadowMeasure::continuous && !elements_->runNote.isEmpty();
    strip_.setNote(ofRuns ? elements_->runNote : elements_->note, elements_->marked);
}

bool ResultLayer::showsTiles() const { return tiles_ && !live_ && (moment_.isEmpty() || !momentCovers_); }

void ResultLayer::showTiles() {
    view_.clearPicture();
    view_.surfaces().clear();
    if (std::exchange(painted_, tiles_) != tiles_) view_.tiles().show(tiles_->tiles);
    strip_.setLegend(tiles_->legend);
    strip_.setNote(tileNote_, tileNoteMarked_);
}

void ResultLayer::setPlaces(std::shared_ptr<const PlaceView> places) {
    if (places == places_) return;
    places_ = std::move(places);
    show();
}

void ResultLayer::setVerdicts(std::shared_ptr<const PlaceView> verdicts) {
    if (verdicts == verdicts_) return;
    verdicts_ = std::move(verdicts);
    show();
}

bool ResultLayer::showsVerdicts() const {
    return verdicts_ && mode_ == ViewMode::review && !showsTiles() && !live_ && !partial_ &&
           moment_.isEmpty();
}

bool ResultLayer::showsPlaces() const {
    return places_ && !showsVerdicts() && !showsTiles() && !live_ && !partial_ &&
           mode_ != ViewMode::exploration && moment_.isEmpty();
}

void ResultLayer::showPlaces(const PlaceView& places) {
    view_.showPicture(places.picture);
    strip_.setLegend(places.legend);
    strip_.setNote(places.note, places.marked);
}

void ResultLayer::setSides(std::optional<ComparedSides> sides) {
    sides_ = std::move(sides);
    show();
}

std::vector<std::string> ResultLayer::missingSides() const {
    std::vector<std::string> missing;
    if (!sides_) return missing;
    for (const ComparedSides::Side* side : {&sides_->displayed, &sides_->other})
        if (showsPlaces() ? !places_->in(side->scenario) : !side->ground) missing.push_back(side->scenario);
    return missing;
}

void ResultLayer::showPlacesOfSides() {
    showPlaces(*places_);
    if (const auto other = places_->in(sides_->other.scenario))
        view_.other().showPicture(other->picture, false);
    if (!places_->in(sides_->displayed.scenario)) view_.clearPicture();
}

std::optional<std::size_t> ResultLayer::elementAt(const glm::dvec3& place) const {
    return showsElements() ? paintedTileAt(place) : std::nullopt;
}

std::optional<std::size_t> ResultLayer::tileAt(const glm::dvec3& place) const {
    return showsTiles() ? paintedTileAt(place) : std::nullopt;
}

std::optional<std::size_t> ResultLayer::paintedTileAt(const glm::dvec3& place) const {
    constexpr double behindM = 0.5;  // a tile may lie a little behind the surface under the cursor
    const CameraPose& pose = view_.pose();
    const glm::dvec3 forward = computeForward(pose);
    glm::dvec3 eye = computeEye(pose);
    if (pose.isParallel()) eye = place - glm::dot(place - eye, forward) * forward;
    const double distance = glm::distance(eye, place);
    if (distance == 0) return std::nullopt;
    return view_.tiles().tileAt({eye, (place - eye) / distance}, distance + behindM);
}

// With the trees that the legend was chosen to show.
GroundAnswer ResultLayer::inChosenColumn(const GroundAnswer& answer) const {
    return showColumn(answer, strip_.choice().trees);
}

// The result with the highest precedence; none yet.
std::optional<GroundAnswer> ResultLayer::ground() const {
    const std::optional<GroundAnswer> none;
    const auto* displayed = sides_ ? &sides_->displayed.ground : &study_;
    for (const auto* answer : {&live_, &partial_, sides_ ? &none : &inFront_, &time_, displayed})
        if (*answer) return inChosenColumn(**answer);
    return std::nullopt;
}

// The other scenario's, on its side.
std::optional<GroundAnswer> ResultLayer::otherGround() const {
    if (!sides_ || !sides_->other.ground || !showsAnswer()) return std::nullopt;
    return inChosenColumn(*sides_->other.ground);
}

void ResultLayer::showExplored() {
    const Legend legend = makeLegend(explored_->view, strip_.measure(), strip_.choice());
    const double topMin = topMinOf(legend);
    view_.surfaces().setPalette(paletteOf(coloursOf(legend), topMin));
    view_.surfaces().show(surfacePicture(explored_->view, strip_.measure(), topMin));
    strip_.setLegend(legend);
    const double distance = glm::length(explored_->view.camera.eye - view_.pose().target);
    strip_.setNote(makeNote(*explored_, distance), coversPart(explored_->view));
}

void ResultLayer::showGround() {
    const auto displayed = ground(), other = otherGround();
    const GroundAnswer& answer = displayed ? *displayed : *other;
    const Legend legend = makeLegend(answer, strip_.measure(), strip_.changeScale(), strip_.choice());
    const auto paint = [&](auto& city, const std::optional<GroundAnswer>& shown) {
        city.clearPicture();
        if (!shown) return;
        city.showPicture(makePicture(*shown, strip_.measure(), legend), !live_ && partial_.has_value());
        if (const auto roofs = roofPictureOf(*shown, strip_.measure(), legend)) city.showRoofPicture(*roofs);
    };
    paint(view_, displayed);
    if (other) paint(view_.other(), other);
    strip_.setLegend(legend);
    strip_.setNote(makeNote(answer, strip_.measure(), strip_.choice().show), answer.marked);
    if (live_ && facades_) showFacades();
}

// One legend for ground and facades where both are minutes of shadow; beside a difference on the ground,
// facades have the usual colours up to its end.
void ResultLayer::showFacades() {
    const ShadowMeasure measure = live_->grossOnly ? ShadowMeasure::gross : strip_.measure();
    const Legend legend = makeLegend(*live_, measure, strip_.changeScale(), strip_.choice());
    view_.tiles().show(
        makeTiles(*facades_->map, measure, legend.change ? plainScale(legend.scale.top) : coloursOf(legend)));
    strip_.setNote(QObject::tr("%1. %2").arg(makeNote(*live_, strip_.measure()), facades_->note),
                   live_->marked);
}

void ResultLayer::showNothing() {
    view_.clearPicture();
    view_.surfaces().clear();
    strip_.setHint(hintOf(mode_));
    strip_.setLegend(std::nullopt);
    strip_.setNote({}, false);
}

void ResultLayer::showMoment() {
    view_.clearPicture();
    view_.surfaces().clear();
    strip_.setHint(moment_);
    strip_.setLegend(std::nullopt);
    strip_.setNote({}, false);
}

QString ResultLayer::minutesAt(const Pick& pick, bool ofOther) const {
    if (ofOther) return minutesOfOther(pick);
    if (showsTiles()) {
        const auto tile = tileAt(pick.position);
        return tile ? tiles_->describe(*tile) : QString();
    }
    if (!moment_.isEmpty() && !live_ && !time_) return {};
    if (mode_ == ViewMode::exploration && !live_) {
        const auto point = explored_ ? explored_->view.pointAt(pick.position) : std::nullopt;
        if (!point) return {};
        const SurfaceShadow& shadow = explored_->view.shadow;
        const float gross = shadow.grossMin[*point], continuous = shadow.continuousMin[*point];
        if (makeLegend(explored_->view, ShadowMeasure::gross).instant)
            return formatMinutes(gross, continuous, true);
        return formatShown(gross, continuous, {strip_.choice().show, shadow.sunlitMinutesPerDay});
    }
    if (showsVerdicts())
        return pick.building ? QString() : verdicts_->describe({pick.position.x, pick.position.y});
    if (const ElementMap* map = shownElements()) {
        const auto element = elementAt(pick.position);
        if (element) return describe(map->elements[*element]);
        if (!live_) return {};
    }
    const glm::dvec2 place{pick.position.x, pick.position.y};
    if (showsPlaces()) return pick.building ? QString() : placeTextAt(place, false);
    const auto shown = ground();
    if (!shown || (pick.building && !isOnRoof(*shown, place))) return {};
    return textAt(*shown, place, strip_.choice().show);
}

// Of the scenario on that side; empty where its places were not measured.
QString ResultLayer::placeTextAt(const glm::dvec2& place, bool ofOther) const {
    if (!sides_) return places_->describe(place);
    const auto places = places_->in((ofOther ? sides_->other : sides_->displayed).scenario);
    return places ? places->describe(place) : QString();
}

QString ResultLayer::minutesOfOther(const Pick& pick) const {
    const glm::dvec2 place{pick.position.x, pick.position.y};
    if (!sides_ || pick.building) return {};
    if (showsPlaces()) return placeTextAt(place, true);
    const auto other = otherGround();
    return other ? textAt(*other, place, strip_.choice().show) : QString();
}

}  // namespace noonmark
