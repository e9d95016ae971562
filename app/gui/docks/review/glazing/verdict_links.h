#pragma once

#include <QObject>
#include <QPointF>
#include <memory>

#include "app/gui/base/layers/field_picture.h"
#include "app/questions/glazing_question.h"

namespace noonmark {

/// Which verdicts on windows the view shows.
enum class ShownVerdicts { after, before, change, none };

/// From the former verdict to the later one.
enum class VerdictChange { same, worse, better, notCompared };
VerdictChange findChange(const GlazingReview& review);

/// Colours of tiles: each two can be told apart with normal and with colour-blind eyes.
QColor tileColour(Verdict verdict);
QColor tileColour(VerdictChange change);

/// "floor 3, before: pass, after: fail", with the window's id in front.
QString describeVerdicts(const GlazingReview& review);

/// A tile for each pane of the answer, in the order of GlazingStudy::panes, with its legend; null: `shown` is
/// none. Some 0.2 us a pane.
std::shared_ptr<const TileView> makeVerdictTiles(const std::shared_ptr<const GlazingAnswer>& answer,
                                                 ShownVerdicts shown);

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
