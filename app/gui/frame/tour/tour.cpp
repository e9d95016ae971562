#include "app/gui/frame/tour/tour.h"

#include <QCoreApplication>
#include <QMainWindow>

#include "app/gui/session/workbench.h"
#include "app/gui/view/panel/view_panel.h"

namespace noonmark {

namespace {

constexpr int watchMs = 100;

QString translateTour(const char* text) { return QCoreApplication::translate("Tour", text); }

}  // namespace

Tour::Tour(const TourPlan& plan, TourStage stage, QObject* parent)
    : QObject(parent),
      plan_(plan),
      stage_(stage),
      bubble_(new TourBubble(stage.window)),
      frame_(new TourFrame(&stage.window)) {
    watch_.setInterval(watchMs);
    connect(&watch_, &QTimer::timeout, this, &Tour::follow);
    connect(bubble_, &TourBubble::showMe, this, &Tour::showMe);
    connect(bubble_, &TourBubble::ended, this, &Tour::end);
}

Tour::~Tour() {
    delete bubble_;
    delete frame_;
}

void Tour::start() {
    enter(0);
    watch_.start();
}

void Tour::enter(std::size_t step) {
    step_ = step;
    before_ = lookBefore(stage_.workbench, stage_.review);
    control_ = std::make_unique<TourControl>(stage_.window, current(), [this] { drawPlace(); });
    connect(control_.get(), &TourControl::done, this, &Tour::takeDone, Qt::QueuedConnection);
    control_->reveal();
    const QString title =
        tr("%1 (%2 of %3)").arg(translateTour(plan_.title)).arg(step + 1).arg(plan_.steps.size());
    bubble_->tell(title, translateTour(current().text), onward());
    follow();
}

TourBubble::Onward Tour::onward() const {
    if (isLast()) return TourBubble::Onward::finish;
    return current().deed == TourDeed::none ? TourBubble::Onward::next : TourBubble::Onward::showMe;
}

// Docks and controls may move, and results come when they are computed.
void Tour::follow() {
    frame_->put(control_->area());
    bubble_->put(control_->area());
    if (isReached(current().goal, before_, lookBefore(stage_.workbench, stage_.review))) enter(step_ + 1);
}

void Tour::takeDone() {
    // An answer of the step before may still be in the queue.
    if (sender() != control_.get() || current().deed == TourDeed::none) return;
    if (current().goal == TourGoal::deed) enter(step_ + 1);
}

void Tour::showMe() {
    if (current().deed != TourDeed::none) return control_->showMe();
    if (!isLast()) enter(step_ + 1);
}

void Tour::end() {
    watch_.stop();
    frame_->hide();
    bubble_->hide();
    Q_EMIT ended();
}

// A lawn in the middle of the study's region, with the tool that the user has.
void Tour::drawPlace() {
    const Box2 box = bounds(stage_.workbench.document().settings().region);
    const auto corner = [&](float x, float y) {
        return glm::dvec3(box.low.x + x * (box.high.x - box.low.x), box.low.y + y * (box.high.y - box.low.y),
                          0);
    };
    PolygonTool& tool = stage_.panel.placeTool();
    tool.begin();
    for (const auto& [x, y] : {std::pair{0.4F, 0.35F}, {0.6F, 0.35F}, {0.6F, 0.5F}, {0.4F, 0.5F}})
        tool.addPoint(corner(x, y));
    tool.finish();
}

}  // namespace noonmark
