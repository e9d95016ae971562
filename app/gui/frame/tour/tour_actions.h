#pragma once

#include <QObject>
#include <QPointer>

#include "app/gui/frame/tour/tour.h"

class QAction;

namespace noonmark {

class OpeningActions;

/// The guided tours of the menu Help. Each opens the sample Central Park South first, and asks before if
/// there is unsaved work.
class TourActions final : public QObject {
    Q_OBJECT
public:
    TourActions(OpeningActions& opening, TourStage stage);

    [[nodiscard]] QList<QAction*> actions() const { return actions_; }
    void start(std::size_t tour);                          ///< an index of listTours()
    [[nodiscard]] Tour* running() const { return tour_; }  ///< null: none

private:
    void begin(std::size_t tour);

    OpeningActions& opening_;
    TourStage stage_;
    QList<QAction*> actions_;
    QPointer<Tour> tour_;
    QMetaObject::Connection waiting_;
};

/// Its title or description in the language of the window.
QString titleOf(const TourPlan& plan);
QString aboutOf(const TourPlan& plan);

}  // namespace noonmark
