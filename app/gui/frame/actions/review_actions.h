#pragma once

#include <QObject>

class QAction;

namespace noonmark {

class EditPreview;
class PlaceActions;
class ReviewDock;
class ReviewSession;
class GlazingSession;
class ViewPanel;
class Workbench;

/// Shows the review dock, and lets the verdicts follow the building that is being
/// shaped.
class ReviewActions final : public QObject {
    Q_OBJECT
public:
    /// All must outlive this object.
    ReviewActions(ReviewSession& review, GlazingSession& windows, ReviewDock& dock, EditPreview& preview,
                  PlaceActions& places, ViewPanel& panel);

    [[nodiscard]] QList<QAction*> actions() const { return {show_, export_}; }

Q_SIGNALS:
    void dockWanted();
    void exportWanted();  ///< of the review, which is displayed

private:
    void tellVerdicts(EditPreview& preview) const;
    void exportReview();

    ReviewSession& review_;
    GlazingSession& windows_;
    ViewPanel& panel_;
    QAction* show_;
    QAction* export_;
};

}  // namespace noonmark
