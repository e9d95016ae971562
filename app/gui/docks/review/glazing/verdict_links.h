#pragma once

#include <QObject>
#include <QPointF>

#include "app/gui/docks/review/glazing/verdict_tiles.h"

namespace noonmark {

class ReviewSession;
class ViewPanel;
class WindowPanel;
class WindowSession;
class Workbench;

/// Shows the verdicts on windows in the view: tiles on the walls as long as a rule about windows is chosen
/// and no other result was computed since. The chosen row is outlined and framed there; a click on a tile
/// selects its row.
class VerdictLinks final : public QObject {
    Q_OBJECT
public:
    /// All must outlive this object.
    VerdictLinks(WindowPanel& table, WindowSession& windows, ReviewSession& review, Workbench& workbench,
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

    WindowPanel& table_;
    WindowSession& windows_;
    ViewPanel& panel_;
    std::shared_ptr<const WindowAnswer> answer_;  ///< in the view
    ShownVerdicts shown_ = ShownVerdicts::none;
};

}  // namespace noonmark
