#include "app/window/result_layer.h"

#include <glm/geometric.hpp>
#include <utility>

#include "app/window/explored_picture.h"
#include "app/window/field_picture.h"
#include "app/window/hover_text.h"
#include "app/window/project/impact_picture.h"

namespace noonmark {

namespace {

QString soFarWords(const PartialField& partial) {
    return QObject::tr("So far: %1 (%2 %)")
        .arg(QString::fromStdString(partial.part))
        .arg(int(partial.share * 100));
}

QString noteOf(const ViewAnswer& answer, double distanceM) {
    const QString words = detailWords(answer.view, distanceM);
    if (isSoFar(answer.view)) return QObject::tr("So far: %1").arg(words);
    return !isFinest(answer) ? QObject::tr("Refining: %1").arg(words) : words;
}

QString hintOf(ViewMode mode) {
    if (mode == ViewMode::exploration) return QObject::tr("Looking for the shadow of what the view shows...");
    return QObject::tr("No study yet: choose a period and a region, then press Run (Ctrl+R)");
}

}  // namespace

ResultLayer::ResultLayer(CityView& view, LegendStrip& legend) : view_(view), strip_(legend) {
    view_.surfaces().setPalette(shadowPalette());
    showNothing();
}

void ResultLayer::forget() {
    study_.reset();
    comparison_.reset();
    partial_.reset();
    time_.reset();
    explored_.reset();
    show();
}

void ResultLayer::setMode(ViewMode mode) {
    mode_ = mode;
    show();
}

void ResultLayer::setStudy(std::shared_ptr<const Study> study) {
    study_ = std::move(study);
    partial_.reset();
    if (mode_ != ViewMode::exploration) show();
}

void ResultLayer::setComparison(std::shared_ptr<const ImpactAnswer> comparison) {
    if (comparison == comparison_) return;
    comparison_ = std::move(comparison);
    partial_.reset();
    if (mode_ != ViewMode::exploration) show();
}

void ResultLayer::setPartial(std::shared_ptr<const PartialField> partial) {
    if (!partial && !partial_) return;
    partial_ = std::move(partial);
    if (mode_ != ViewMode::exploration) show();
}

void ResultLayer::setTime(std::shared_ptr<const TimeAnswer> answer) {
    if (answer == time_) return;
    time_ = std::move(answer);
    if (mode_ != ViewMode::exploration) show();
}

void ResultLayer::setExplored(std::shared_ptr<const ViewAnswer> answer) {
    explored_ = std::move(answer);
    if (mode_ == ViewMode::exploration) show();
}

void ResultLayer::setLive(const ShadowField* field, const Receivers* receivers, const QString& note) {
    const bool wasLive = std::exchange(live_, field != nullptr);
    if (!field && wasLive) show();
    if (!field) return;
    if (!wasLive) view_.surfaces().clear();
    const Legend legend = legendOf(*field, ShadowMeasure::gross);
    view_.showPicture(fieldPicture(*field, receivers, ShadowMeasure::gross, legend.scale.top));
    strip_.setLegend(legend);
    strip_.setNote(note, false);
}

void ResultLayer::show() {
    if (live_) return;
    if (mode_ == ViewMode::exploration) {
        view_.clearPicture();
        return explored_ ? showExplored() : showNothing();
    }
    view_.surfaces().clear();
    if (comparison_ && !partial_) return showComparison();
    if (groundField()) return showGround();
    showNothing();
}

void ResultLayer::showExplored() {
    const Legend legend = legendOf(explored_->view, strip_.measure());
    view_.surfaces().show(surfacePicture(explored_->view, strip_.measure(), legend.scale.top));
    strip_.setLegend(legend);
    const double distance = glm::length(explored_->view.camera.eye - view_.pose().target);
    strip_.setNote(noteOf(*explored_, distance), isSoFar(explored_->view));
}

const ShadowField* ResultLayer::groundField() const {
    if (partial_) return &partial_->field;
    if (time_) return &time_->field;
    return study_ ? &study_->field : nullptr;
}

void ResultLayer::showGround() {
    const ShadowField& field = *groundField();
    const bool part = partial_ != nullptr;
    // Horizons that stay count no longest runs.
    const ShadowMeasure measure = time_ && !part ? ShadowMeasure::gross : strip_.measure();
    const Study* study = time_ ? time_->study.get() : study_.get();
    const Legend legend = legendOf(field, measure);
    view_.showPicture(fieldPicture(field, part ? nullptr : &study->receivers, measure, legend.scale.top),
                      part);
    strip_.setLegend(legend);
    strip_.setNote(part ? soFarWords(*partial_) : time_ ? wordsOf(time_->look) : QString(), part);
}

void ResultLayer::showComparison() {
    const Impact& impact = comparison_->study.total;
    const Legend legend = legendOf(impact, strip_.measure());
    view_.showPicture(impactPicture(impact, strip_.measure(), legend.scale.top));
    strip_.setLegend(legend);
    strip_.setNote(
        QObject::tr("%1 compared with %2")
            .arg(QString::fromStdString(comparison_->to), QString::fromStdString(comparison_->from)),
        false);
}

void ResultLayer::showNothing() {
    view_.clearPicture();
    view_.surfaces().clear();
    strip_.setHint(hintOf(mode_));
    strip_.setLegend(std::nullopt);
    strip_.setNote({}, false);
}

QString ResultLayer::minutesAt(const Pick& pick) const {
    if (live_) return {};
    if (mode_ == ViewMode::exploration) {
        const auto point = explored_ ? explored_->view.pointAt(pick.position) : std::nullopt;
        if (!point) return {};
        const SurfaceShadow& shadow = explored_->view.shadow;
        return minutesText(shadow.grossMin[*point], shadow.continuousMin[*point],
                           legendOf(explored_->view, ShadowMeasure::gross).instant);
    }
    if (pick.building) return {};
    if (comparison_ && !partial_)
        return changeText(comparison_->study.total, {pick.position.x, pick.position.y});
    const ShadowField* field = groundField();
    return field ? minutesText(*field, {pick.position.x, pick.position.y}) : QString();
}

std::optional<Legend> ResultLayer::legend() const {
    std::optional<Legend> legend = strip_.legend();
    if (legend && !strip_.note().isEmpty()) legend->unit += QStringLiteral(". ") + strip_.note();
    return legend;
}

}  // namespace noonmark
