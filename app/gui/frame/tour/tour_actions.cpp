#include "app/gui/frame/tour/tour.h"

#include <QCoreApplication>
#include <utility>

#include "app/gui/base/widgets/buttons.h"
#include "app/gui/frame/actions/opening_actions.h"
#include "app/gui/session/workbench.h"

namespace noonmark {

QString titleOf(const TourPlan& plan) { return QCoreApplication::translate("Tour", plan.title); }
QString aboutOf(const TourPlan& plan) { return QCoreApplication::translate("Tour", plan.about); }

TourActions::TourActions(OpeningActions& opening, TourStage stage) : opening_(opening), stage_(stage) {
    const auto tours = listTours();
    for (std::size_t i = 0; i < tours.size(); ++i) {
        actions_ << makeAction(this, titleOf(tours[i]), {}, aboutOf(tours[i]));
        connect(actions_.last(), &QAction::triggered, this, [this, i] { start(i); });
    }
}

void TourActions::start(std::size_t tour) {
    delete tour_;
    disconnect(waiting_);
    waiting_ = connect(
        &stage_.workbench, &Workbench::projectOpened, this, [this, tour] { begin(tour); },
        Qt::QueuedConnection);
    opening_.open({QStringLiteral("sample:central-park-south")});
}

void TourActions::begin(std::size_t tour) {
    disconnect(waiting_);
    tour_ = new Tour(listTours()[tour], stage_, this);
    connect(tour_, &Tour::ended, this, [this] { std::exchange(tour_, nullptr)->deleteLater(); });
    tour_->start();
}

}  // namespace noonmark
