#pragma once

#include <QObject>
#include <QPointF>

#include "app/gui/docks/review/glazing/verdict_tiles.h"

namespace noonmark {

class ReviewSession;
class ViewPanel;
class GlazingPanel;
class GlazingSession;
class Workbench;

/// Shows the verdicts on windows in the view: tiles on the walls as long as a rule about windows is chosen
/// and no other result was computed since. The chosen row is outlined and framed there; a click on a tile
/// selects its row.
class VerdictLinks final : public QObject {
    Q_OBJECT
public:
    /// All must outlive this object.
    VerdictLinks(GlazingPanel& table, GlazingSession& windows, ReviewSession& review, Workbench& workbench,
                 ViewPanel& panel);

private:
    void connectTable();
    void connectOtherResults(Workbench& workbench, ReviewSession& review);
    void takeAnswer();
    void show();
    void note();
    void mark(std::size_t window);
    void goTo(std::size_t window);
    void click(QPointF pixel);

    GlazingPanel& table_;
    GlazingSession& windows_;
    ViewPanel& panel_;
    std::shared_ptr<const GlazingAnswer> answer_;  ///< in the view
    ShownVerdicts shown_ = ShownVerdicts::none;
};

}  // namespace noonmark
