#include "app/window/view_panel.h"

#include <QDragEnterEvent>
#include <QDropEvent>
#include <QMimeData>
#include <QVBoxLayout>

#include "app/report/study_words.h"
#include "app/window/ground_lines.h"
#include "app/window/hover_text.h"
#include "app/window/view_picture.h"
#include "app/window/visible_ground.h"

namespace noonmark {

ViewPanel::ViewPanel(QWidget* parent)
    : QWidget(parent),
      view_(new CityView),
      navigator_(new ViewNavigator(*view_)),
      tool_(new RegionTool(this)),
      messages_(new MessageBar),
      legend_(new LegendStrip),
      results_(std::make_unique<ResultLayer>(*view_, *legend_)) {
    QWidget* container = QWidget::createWindowContainer(view_, this);
    container->setMinimumSize(320, 240);
    container->setFocusPolicy(Qt::StrongFocus);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addWidget(messages_);
    column->addWidget(container, 1);
    column->addWidget(legend_);
    setAcceptDrops(true);
    view_->installEventFilter(this);  // the native window under the container takes the drops
    connect(view_, &CityView::poseChanged, this, [this] { legend_->setHeading(view_->pose().headingDeg); });
    connect(legend_, &LegendStrip::measureChanged, this, [this] { results_->show(); });
    connect(navigator_, &ViewNavigator::hovered, this, &ViewPanel::tellWhatIsAt);
    connect(navigator_, &ViewNavigator::left, this, [this] { Q_EMIT hovered({}); });
    connectTool();
}

void ViewPanel::connectTool() {
    connect(navigator_, &ViewNavigator::clicked, this, [this](QPointF pixel) {
        if (const auto ground = navigator_->groundAt(pixel)) tool_->addPoint(*ground);
    });
    connect(navigator_, &ViewNavigator::doubleClicked, tool_, &RegionTool::finish);
    connect(navigator_, &ViewNavigator::rightClicked, tool_, &RegionTool::finish);
    connect(navigator_, &ViewNavigator::keyPressed, this, &ViewPanel::toolKey);
    connect(tool_, &RegionTool::lineChanged, this, &ViewPanel::showLines);
    connect(tool_, &RegionTool::refused, messages_, &MessageBar::showError);
    connect(tool_, &RegionTool::activeChanged, this, [this](bool active) {
        if (active)
            view_->setCursor(Qt::CrossCursor);
        else
            view_->unsetCursor();
    });
}

void ViewPanel::toolKey(int key) {
    if (key == Qt::Key_Return || key == Qt::Key_Enter) tool_->finish();
    if (key == Qt::Key_Escape) tool_->cancel();
    if (key == Qt::Key_Backspace) tool_->removeLastPoint();
}

void ViewPanel::showCity(std::shared_ptr<const OpenCity> city) {
    city_ = std::move(city);
    tool_->cancel();
    navigator_->setScene(city_->picker);
    view_->showCity(city_->arrays);
    results_->forget();
}

void ViewPanel::showRegion(const Region& region) {
    region_ = region;
    showLines();
}

void ViewPanel::showLines() {
    if (!city_) return;
    if (tool_->active()) return view_->showLines({groundLineOf(tool_->line(), city_->city(), true)});
    view_->showLines(groundLinesOf(region_, city_->city()));
}

void ViewPanel::tellWhatIsAt(QPointF pixel) {
    if (!city_) return;
    if (tool_->active())
        if (const auto ground = navigator_->groundAt(pixel)) tool_->moveTo(*ground);
    const auto pick = navigator_->pickAt(pixel);
    Q_EMIT hovered(pick ? hoverText(*pick, city_->city(), results_->minutesAt(*pick)) : QString());
}

Region ViewPanel::visibleGround() const {
    return noonmark::visibleGround(view_->pose(), view_->lens(), view_->viewBounds());
}

void ViewPanel::takePicture(std::function<void(QImage)> done) {
    const QString credit = city_ ? dataWords(city_->loaded.read.attribution) : QString();
    view_->capture([legend = results_->legend(), credit, done = std::move(done)](const QImage& image) {
        done(viewPicture(image, legend, credit));
    });
}

bool ViewPanel::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::DragEnter || event->type() == QEvent::DragMove) {
        dragEnterEvent(static_cast<QDragEnterEvent*>(event));
        return true;
    }
    if (event->type() == QEvent::Drop) {
        dropEvent(static_cast<QDropEvent*>(event));
        return true;
    }
    return QWidget::eventFilter(watched, event);
}

void ViewPanel::dragEnterEvent(QDragEnterEvent* event) {
    if (event->mimeData()->hasUrls()) event->acceptProposedAction();
}

void ViewPanel::dropEvent(QDropEvent* event) {
    QStringList files;
    for (const QUrl& url : event->mimeData()->urls())
        if (url.isLocalFile()) files << url.toLocalFile();
    event->acceptProposedAction();
    if (!files.isEmpty()) Q_EMIT filesDropped(files);
}

}  // namespace noonmark
