#include "app/gui/docks/point/point_dock.h"

#include <QBoxLayout>
#include <QEvent>
#include <QFileInfo>
#include <QImage>
#include <QLabel>
#include <QPushButton>
#include <QScrollArea>

#include "app/gui/base/widgets/error_words.h"
#include "app/gui/base/widgets/number_words.h"
#include "app/gui/docks/point/point_inspector.h"
#include "app/gui/docks/point/point_scenarios.h"
#include "app/gui/docks/point/sky_picture.h"
#include "core/io/files/write_text.h"
#include "core/study/text/point_text.h"

namespace noonmark {

namespace {

constexpr int textWidth = 300;
constexpr int savedWidthPx = 2400;

QString figuresOf(const PointView& view, const PointStudy& study, const Zone& zone) {
    const double lit = study.possibleMin - view.year.grossMin * double(study.sun.dayCount());
    QString text = PointDock::tr("In the sun on %1: %2\nIn the year: %3 h of %4 h\nSky view factor: %5")
                       .arg(QString::fromStdString(formatText(study.question.day)),
                            QString::fromStdString(sunlitText(view, zone)))
                       .arg(groupDigits(lit / 60, 0))
                       .arg(groupDigits(study.possibleMin / 60, 0))
                       .arg(groupDigits(view.factors.skyView, 3));
    if (study.question.facingDeg)
        text +=
            PointDock::tr("\nVertical sky component: %1 %").arg(groupDigits(view.factors.skyComponentPct, 1));
    return text;
}

QLabel* makeText() {
    auto* label = new QLabel;
    label->setWordWrap(true);
    label->setAlignment(Qt::AlignTop);
    label->setTextInteractionFlags(Qt::TextSelectableByMouse);
    return label;
}

}  // namespace

PointDock::PointDock(PointInspector& inspector, QWidget* parent)
    : QWidget(parent),
      inspector_(inspector),
      sentence_(makeText()),
      figures_(makeText()),
      save_(new QPushButton(tr("Save..."))),
      picture_(new SkyPicture),
      scroll_(new QScrollArea) {
    scroll_->setWidget(picture_);
    scroll_->setFrameShape(QFrame::NoFrame);
    scroll_->viewport()->installEventFilter(this);
    auto* row = new QHBoxLayout(this);
    row->addWidget(makeSide());
    row->addWidget(scroll_, 1);
    connect(save_, &QPushButton::clicked, this, &PointDock::saveRequested);
    connect(&inspector_, &PointInspector::changed, this, &PointDock::showAnswer);
    connect(&inspector_, &PointInspector::failed, this, &PointDock::showError);
    showAnswer();
}

// The texts and the button, which scroll where the dock is low.
QWidget* PointDock::makeSide() {
    save_->setToolTip(tr("The drawing as SVG or PNG, or the minutes by month and hour as CSV"));
    auto* side = new QWidget;
    auto* texts = new QVBoxLayout(side);
    texts->addWidget(sentence_);
    texts->addWidget(figures_);
    texts->addWidget(new PointScenarios(inspector_));
    texts->addWidget(save_, 0, Qt::AlignLeft);
    texts->addStretch();
    auto* scroll = new QScrollArea;
    scroll->setWidget(side);
    scroll->setWidgetResizable(true);
    scroll->setFrameShape(QFrame::NoFrame);
    scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    scroll->setFixedWidth(textWidth);
    return scroll;
}

void PointDock::showEvent(QShowEvent* /*event*/) { inspector_.setVisible(true); }

void PointDock::hideEvent(QHideEvent* /*event*/) { inspector_.setVisible(false); }

bool PointDock::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::Resize) picture_->fitInto(scroll_->viewport()->size());
    return QWidget::eventFilter(watched, event);
}

void PointDock::showAnswer() {
    const auto answer = inspector_.answer();
    save_->setVisible(answer != nullptr);
    picture_->setDrawing(answer ? answer->drawing : QByteArray());
    figures_->clear();
    sentence_->setText(tr("Right-click the ground, a roof or a wall and choose Sun and sky here."));
    if (!answer) return;
    sentence_->setText(answer->sentence);
    const auto zone = Zone::named(answer->study.question.zone);
    if (!zone) return;
    QString figures = figuresOf(answer->study.baseline, answer->study, *zone);
    if (answer->study.scenario)
        figures = tr("Before: %1\n%2\n\nAfter: %3\n%4")
                      .arg(QString::fromStdString(answer->from), figures, QString::fromStdString(answer->to),
                           figuresOf(*answer->study.scenario, answer->study, *zone));
    figures_->setText(figures);
}

void PointDock::showError(const Error& error) { sentence_->setText(describeError(error)); }

Result<void> PointDock::save(const QString& file, const OutputRules& rules) {
    const auto answer = inspector_.answer();
    if (!answer || file.isEmpty()) return {};
    const QString ending = QFileInfo(file).suffix().toLower();
    const OutputKind kind = ending == QStringLiteral("png")   ? OutputKind::picture
                            : ending == QStringLiteral("csv") ? OutputKind::table
                                                              : OutputKind::svg;
    if (const auto may = checkOutput(file.toStdString(), kind, rules); !may) return may;
    if (kind == OutputKind::svg) return writeText(file.toStdString(), answer->drawing.toStdString());
    if (kind == OutputKind::table) return writeText(file.toStdString(), pointCsv(answer->study));
    if (picture_->image(savedWidthPx).save(file)) return {};
    return failure("The picture could not be written", file.toStdString(), "Choose another folder");
}

}  // namespace noonmark
