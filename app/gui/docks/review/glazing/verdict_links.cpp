#include "app/gui/docks/review/glazing/verdict_links.h"

#include <algorithm>
#include <array>

#include "app/gui/base/widgets/name_text.h"
#include "app/gui/docks/review/glazing/glazing_panel.h"
#include "app/gui/docks/review/glazing/glazing_session.h"
#include "app/gui/docks/review/verdict_table.h"
#include "app/gui/session/workbench.h"
#include "app/gui/view/panel/view_panel.h"
#include "app/gui/view/panel/view_presets.h"
#include "app/report/maps/answer_legends.h"
#include "core/describe/text.h"
#include "core/receivers/points/glazing_pane.h"

namespace noonmark {

namespace {

constexpr std::array shownClasses{Verdict::pass, Verdict::borderline, Verdict::fail, Verdict::notApplicable};
constexpr std::array shownChanges{VerdictChange::same, VerdictChange::worse, VerdictChange::better,
                                  VerdictChange::notCompared};

// The words of legends are English here, as in files.
QString wordOf(VerdictChange change) {
    constexpr std::array words{NM_TEXT("the same"), NM_TEXT("worse"), NM_TEXT("better"),
                               NM_TEXT("not compared")};
    return QString::fromLatin1(words[std::size_t(change)]);
}

QColor colourOf(const GlazingReview& review, ShownVerdicts shown) {
    if (shown == ShownVerdicts::change) return tileColour(findChange(review));
    return tileColour(shown == ShownVerdicts::before ? review.formerVerdict : review.verdict);
}

Legend makeVerdictLegend(ShownVerdicts shown) {
    Legend legend;
    const bool ofChange = shown == ShownVerdicts::change;
    legend.title = ofChange ? QStringLiteral(NM_TEXT("Change of verdicts"))
                            : QStringLiteral(NM_TEXT("Verdicts on windows"));
    legend.unit = ofChange                         ? QStringLiteral(NM_TEXT("from before to after"))
                  : shown == ShownVerdicts::before ? QStringLiteral(NM_TEXT("before"))
                                                   : QStringLiteral(NM_TEXT("after"));
    if (ofChange)
        for (const VerdictChange change : shownChanges)
            legend.classes.push_back({tileColour(change), wordOf(change)});
    else
        for (const Verdict verdict : shownClasses)
            legend.classes.push_back({tileColour(verdict), QString::fromUtf8(nameOf(verdict).data())});
    return legend;
}

}  // namespace

VerdictChange findChange(const GlazingReview& review) {
    const auto isKnown = [](Verdict verdict) {
        return verdict != Verdict::notApplicable && verdict != Verdict::notChecked;
    };
    if (!isKnown(review.formerVerdict) || !isKnown(review.verdict)) return VerdictChange::notCompared;
    if (isWorse(review.formerVerdict, review.verdict)) return VerdictChange::worse;
    return isWorse(review.verdict, review.formerVerdict) ? VerdictChange::better : VerdictChange::same;
}

QColor tileColour(Verdict verdict) { return verdictMark(verdict); }

QColor tileColour(VerdictChange change) {
    switch (change) {
        case VerdictChange::worse:
            return tileColour(Verdict::fail);
        case VerdictChange::better:
            return tileColour(Verdict::pass);
        case VerdictChange::same:
            return {0xf4, 0xec, 0xd8};
        case VerdictChange::notCompared:
            break;
    }
    return {0x8a, 0x8d, 0x92};
}

QString describeVerdicts(const GlazingReview& review) {
    return QObject::tr("%1, floor %2   before: %3, after: %4")
        .arg(QString::fromStdString(review.window.id))
        .arg(review.window.floor)
        .arg(describeVerdict(review.formerVerdict), describeVerdict(review.verdict));
}

std::shared_ptr<const TileView> makeVerdictTiles(const std::shared_ptr<const GlazingAnswer>& answer,
                                                 ShownVerdicts shown) {
    if (!answer || shown == ShownVerdicts::none) return nullptr;
    const auto view = std::make_shared<TileView>();
    const GlazingStudy& study = answer->study;
    view->tiles.reserve(study.panes.size());
    for (const ReviewedPane& pane : study.panes) {
        const QColor colour = colourOf(study.windows[pane.window], shown);
        view->tiles.push_back({computePaneCorners(pane.pane.middle, pane.pane.normal, pane.pane.size),
                               glm::vec3(colour.redF(), colour.greenF(), colour.blueF())});
    }
    view->legend = makeVerdictLegend(shown);
    view->describe = [answer](std::size_t tile) {
        return describeVerdicts(answer->study.windows[answer->study.panes[tile].window]);
    };
    return view;
}

VerdictLinks::VerdictLinks(GlazingPanel& table, GlazingSession& windows, ReviewSession& review,
                           Workbench& workbench, ViewPanel& panel)
    : table_(table), windows_(windows), panel_(panel) {
    connect(&windows_, &GlazingSession::answered, this, &VerdictLinks::takeAnswer);
    connect(&panel_.navigator(), &ViewNavigator::clicked, this, &VerdictLinks::click);
    connectTable();
    connectOtherResults(workbench, review);
}

void VerdictLinks::connectTable() {
    connect(&table_, &GlazingPanel::shownChanged, this, &VerdictLinks::show);
    connect(&table_.table(), &GlazingTable::highlighted, this, &VerdictLinks::mark);
    connect(&table_.table(), &GlazingTable::goToRequested, this, &VerdictLinks::goTo);
}

// What the user computed or chose last is in front.
void VerdictLinks::connectOtherResults(Workbench& workbench, ReviewSession& review) {
    connect(&workbench, &Workbench::answered, &table_,
            [this, &workbench] { workbench.answerAs<GlazingAnswer>() ? takeAnswer() : table_.suspend(); });
    connect(&workbench.running(), &JobSlot::started, &table_, &GlazingPanel::suspend);
    for (auto changed : {&ReviewSession::changed, &ReviewSession::answered})
        connect(&review, changed, this, &VerdictLinks::show);
}

void VerdictLinks::takeAnswer() {
    table_.resumeShown();
    show();
}

void VerdictLinks::show() {
    const auto answer = windows_.applies() ? windows_.answer() : nullptr;
    note();
    const bool isSame = answer == answer_ && table_.shown() == shown_;
    if (isSame) return;
    answer_ = answer;
    shown_ = table_.shown();
    panel_.results().setTiles(makeVerdictTiles(answer_, shown_));
    if (const auto window = table_.table().chosen()) mark(*window);
}

void VerdictLinks::note() {
    if (!windows_.answer()) return;
    const QString why = windows_.whyOutdated();
    const GlazingQuestion& asked = windows_.answer()->question;
    panel_.results().noteTiles(
        why.isEmpty() ? tr("%1: %2 compared with %3")
                            .arg(ruleName(asked.rule.name), scenarioName(asked.to), scenarioName(asked.from))
                      : why,
        !why.isEmpty());
}

void VerdictLinks::mark(std::size_t window) {
    if (!answer_ || !panel_.results().showsTiles()) return;
    std::vector<std::size_t> tiles;
    for (std::size_t i = 0; i < answer_->study.panes.size(); ++i)
        if (answer_->study.panes[i].window == window) tiles.push_back(i);
    panel_.view().tiles().highlight(tiles);
}

void VerdictLinks::goTo(std::size_t window) {
    table_.resumeShown();
    if (!answer_) return;
    const auto& panes = answer_->study.panes;
    const auto pane = std::ranges::find(panes, window, &ReviewedPane::window);
    if (pane == panes.end()) return;
    const auto& azimuth = answer_->study.windows[window].window.azimuthDeg;
    panel_.view().setPose(faceWall(panel_.view().pose(), pane->pane.middle, azimuth));
    mark(window);
}

void VerdictLinks::click(QPointF pixel) {
    if (panel_.drawing() || !panel_.results().showsTiles()) return;
    const auto pick = panel_.navigator().pickAt(pixel);
    const auto tile = pick ? panel_.results().tileAt(pick->position) : std::nullopt;
    if (tile) table_.table().choose(answer_->study.panes[*tile].window);
}

}  // namespace noonmark
