#pragma once

#include <QWidget>

#include "app/gui/docks/review/review_session.h"

class QLabel;
class QPushButton;
class QStackedWidget;
class QTimer;

namespace noonmark {

class ElementForm;
class GlazingForm;
class GlazingSession;
class PlaceList;
class ProgressStrip;
class ProjectSession;
class RuleForm;

/// Asks a review's question: rule, scenarios, places or windows. At its foot what it costs, and the button
/// that runs it.
class ReviewForm final : public QWidget {
    Q_OBJECT
public:
    /// All must outlive it.
    ReviewForm(ReviewSession& review, GlazingSession& windows, ProjectSession& project,
               QWidget* parent = nullptr);

    /// The building that is selected in the view, whose windows may be reviewed; empty: none.
    void setSelectedBuilding(const QString& id);
    [[nodiscard]] ElementForm& elements();  ///< which windows a rule is evaluated on
    /// A place that was drawn for the review: it is reviewed, and its name can be typed.
    void takeDrawn(const std::string& place);

Q_SIGNALS:
    void placePointedAt(const std::string& place);  ///< to be highlighted in the view
    void drawPlaceRequested(noonmark::PlaceKind kind);

protected:
    void showEvent(QShowEvent* event) override;

private:
    QWidget* makeChoices();
    QWidget* makeFoot();
    void connectSessions();
    void connectChoices();
    void showChoice();
    void rename(const std::string& from, const std::string& to);
    void showEstimate(const QString& words, bool ofGlazing);

    ReviewSession& review_;
    GlazingSession& windows_;
    ProjectSession& project_;
    RuleForm* form_;
    QStackedWidget* subjects_;  ///< places_ or glazingForm_
    PlaceList* places_;
    GlazingForm* glazingForm_;
    QPushButton* run_;
    QLabel* estimate_;
    ProgressStrip* progress_;
    QTimer* estimateSoon_;
};

}  // namespace noonmark
