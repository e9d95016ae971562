#pragma once

#include <QObject>

class QAction;
class QWidget;

namespace noonmark {

class EditPreview;
class PlaceActions;
class ReviewDock;
class ReviewSession;
class ViewPanel;
class Workbench;

/// Shows the review dock, exports reviews, and lets the verdicts follow the building that is being shaped.
class ReviewActions final : public QObject {
    Q_OBJECT
public:
    /// Dialogs belong to `window`. All must outlive this object.
    ReviewActions(Workbench& workbench, ReviewSession& review, ReviewDock& dock, const EditPreview& preview,
                  PlaceActions& places, ViewPanel& panel, QWidget& window);

    [[nodiscard]] QList<QAction*> actions() const { return {show_, export_}; }

Q_SIGNALS:
    void dockWanted();

private:
    void exportReview();

    Workbench& workbench_;
    ReviewSession& review_;
    ViewPanel& panel_;
    QWidget& window_;
    QAction* show_;
    QAction* export_;
};

}  // namespace noonmark
