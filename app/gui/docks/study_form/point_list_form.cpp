#include "app/gui/docks/study_form/point_list_form.h"

#include <fmt/format.h>

#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QVBoxLayout>
#include <algorithm>

#include "app/gui/base/files/file_dialogs.h"
#include "app/gui/base/looks/theme.h"
#include "app/gui/base/widgets/error_words.h"
#include "app/gui/base/widgets/push_button.h"
#include "core/io/elements/read_point_file.h"

namespace noonmark {

PointListForm::PointListForm(QWidget* parent)
    : QWidget(parent),
      text_(new QPlainTextEdit),
      pick_(
          pushButton(tr("Click points"), "pickPoints",
                     tr("Click the ground, roofs or walls in the view: each click adds a point. Press again "
                        "to end"))),
      read_(pushButton(tr("Read CSV..."), "readPoints",
                       tr("Replaces the list by a CSV file with columns id, lon, lat, height, facing"))),
      problem_(new QLabel) {
    text_->setObjectName(QStringLiteral("pointList"));
    text_->setToolTip(tr(
        "One point a line: id, longitude, latitude (degrees), metres above the ground, azimuth that a wall "
        "faces. Without a height the point is on the ground or roof, without an azimuth it is level"));
    text_->setPlaceholderText(QStringLiteral("id,lon,lat,height,facing"));
    text_->setTabChangesFocus(true);
    text_->setLineWrapMode(QPlainTextEdit::NoWrap);
    text_->setFixedHeight(6 * fontMetrics().lineSpacing());
    text_->installEventFilter(this);
    pick_->setCheckable(true);
    problem_->setWordWrap(true);
    problem_->hide();
    showAsError(*problem_);
    auto* buttons = new QHBoxLayout;
    buttons->addWidget(pick_);
    buttons->addWidget(read_);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->addWidget(text_);
    column->addWidget(problem_);
    column->addLayout(buttons);
    connect(read_, &QPushButton::clicked, this, &PointListForm::readFile);
    connect(pick_, &QPushButton::toggled, this, [this](bool on) {
        if (on) Q_EMIT pickingBegan();
    });
}

bool PointListForm::eventFilter(QObject* watched, QEvent* event) {
    if (watched == text_ && event->type() == QEvent::FocusOut) take();
    return QWidget::eventFilter(watched, event);
}

// What was typed stays where it is wrong, with the reason below it.
void PointListForm::take() {
    const QString text = text_->toPlainText();
    std::vector<ListedPoint> points;
    if (!text.trimmed().isEmpty()) {
        auto parsed = parsePointList(text.toStdString(), tr("points").toStdString());
        if (!parsed) return tell(describeError(parsed.error()));
        points = *std::move(parsed);
    }
    tell({});
    if (points == points_) return;
    points_ = std::move(points);
    Q_EMIT edited(points_, tr("points"));
}

void PointListForm::readFile() {
    const QString file = askForPoints(this);
    if (file.isEmpty()) return;
    auto points = readPointFile(file.toStdString());
    if (!points) return tell(describeError(points.error()));
    show(*points);
    Q_EMIT edited(points_, tr("points"));
}

void PointListForm::tell(const QString& problem) {
    problem_->setText(problem);
    problem_->setVisible(!problem.isEmpty());
}

void PointListForm::show(const std::vector<ListedPoint>& points) {
    if (points == points_ && !text_->toPlainText().isEmpty()) return;
    points_ = points;
    text_->setPlainText(points.empty() ? QString() : QString::fromStdString(toCsv(points)));
    tell({});
}

void PointListForm::add(ListedPoint point) {
    for (std::size_t number = points_.size() + 1; point.id.empty(); ++number) {
        const std::string id = fmt::format("point {}", number);
        const bool used = std::ranges::any_of(points_, [&](const ListedPoint& one) { return one.id == id; });
        if (!used) point.id = id;
    }
    auto points = points_;
    points.push_back(std::move(point));
    show(points);
    Q_EMIT edited(points_, tr("points"));
}

void PointListForm::endPicking() { pick_->setChecked(false); }

bool PointListForm::picking() const { return pick_->isChecked() && isVisible(); }

}  // namespace noonmark
