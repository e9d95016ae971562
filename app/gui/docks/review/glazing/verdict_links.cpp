#include "app/gui/docks/review/glazing/verdict_links.h"

#include <algorithm>

#include "app/gui/docks/review/glazing/glazing_panel.h"
#include "app/gui/docks/review/glazing/glazing_session.h"
#include "app/gui/docks/review/glazing/glazing_table.h"
#include "app/gui/session/workbench.h"
#include "app/gui/view/panel/view_panel.h"
#include "app/gui/view/panel/wall_view.h"

namespace noonmark {

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
    connect(&table_.table(), &GlazingTable::pointedAt, this, &VerdictLinks::mark);
    connect(&table_.table(), &GlazingTable::wanted, this, &VerdictLinks::goTo);
}

// What the user computed or chose last is in front.
void VerdictLinks::connectOtherResults(Workbench& workbench, ReviewSession& review) {
    connect(&workbench, &Workbench::answered, &table_,
            [this, &workbench] { workbench.answerAs<GlazingAnswer>() ? takeAnswer() : table_.putAway(); });
    connect(&workbench.running(), &JobSlot::started, &table_, &GlazingPanel::putAway);
    for (auto changed : {&ReviewSession::changed, &ReviewSession::answered})
        connect(&review, changed, this, &VerdictLinks::show);
}

void VerdictLinks::takeAnswer() {
    table_.bringBack();
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
                            .arg(QString::fromStdString(asked.rule.name), QString::fromStdString(asked.to),
                                 QString::fromStdString(asked.from))
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
    table_.bringBack();
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
