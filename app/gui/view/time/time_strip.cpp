#include "app/gui/view/time/time_strip.h"

#include <QComboBox>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSignalBlocker>
#include <QStandardItemModel>
#include <QTimer>
#include <QToolButton>
#include <array>

#include "app/gui/base/looks/theme.h"
#include "app/gui/base/widgets/buttons.h"
#include "app/gui/base/widgets/marked_slider.h"
#include "app/gui/base/widgets/number_text.h"

namespace noonmark {

namespace {

constexpr int tickMs = 40;
constexpr int minStripWidth = 256;  // with what cannot be left out
// Narrower strips hide loop and speed, and before these the words about the sun, which the note of the legend
// has, too: sliders need room for the names of their marks.
constexpr int fullWidth = 640, wordyWidth = 800;
constexpr int answerWidth = 500;                 // with what was computed for the moment, where there is such
constexpr std::array playSpeeds{0.5, 1.5, 4.0};  // hours of the day, or weeks of the year, in a second

MarkedSlider* slider(const char* name, const QString& tip, int last, int page) {
    auto* slider = new MarkedSlider;
    slider->setObjectName(QString::fromLatin1(name));
    slider->setToolTip(tip);
    slider->setRange(0, last);
    slider->setPageStep(page);
    return slider;
}

QDate firstOfYear(CivilDate date) { return {int(date.year()), 1, 1}; }

/// Of the longest date.
int widthOfDay() {
    int widest = 0;
    const QLineEdit field;
    for (int month = 1; month <= 12; ++month)
        widest = std::max(widest, field.fontMetrics().horizontalAdvance(
                                      QLocale().toString(QDate(2026, month, 28), shortDay())));
    constexpr int framePx = 16;
    return widest + framePx;
}

QTime timeOf(std::chrono::minutes at) { return QTime(0, 0).addSecs(int(at.count()) * 60); }

QComboBox* shortList(const char* name, const QStringList& entries, const QString& tip) {
    auto* list = new QComboBox;
    list->setObjectName(QString::fromLatin1(name));
    list->addItems(entries);
    list->setToolTip(tip);
    return list;
}

}  // namespace

TimeStrip::TimeStrip(QWidget* parent) : QWidget(parent) {
    makeFields();
    makePlayer();
    place();
    connectFields();
    showLook();
}

void TimeStrip::makeFields() {
    span_ = shortList("lookSpan", {tr("Whole period"), tr("One day"), tr("One moment")},
                      tr("What is shown: the whole period; one day of a study, from horizons cached in steps "
                         "of half a degree;\nor sun and shadow at one moment, on everything"));
    date_ =
        slider("lookDate",
               tr("The date, in the year of the period. Arrows: a day; Page Up and Down: a month"), 364, 30);
    time_ =
        slider("lookTime",
               tr("The wall-clock time; yellow: the sun is up. Arrows: a minute; Page Up and Down: an hour"),
               minutesOfDay - 1, 60);
    dateField_ = new QLineEdit;
    dateField_->setObjectName(QStringLiteral("lookDateField"));
    dateField_->setToolTip(tr("The date: 21 Dec, 12-21, or 21 for a day of this month"));
    dateField_->setFixedWidth(widthOfDay());
    timeField_ = new QLineEdit;
    timeField_->setObjectName(QStringLiteral("lookTimeField"));
    timeField_->setToolTip(tr("The wall-clock time: 14:30, 1430, or 14"));
    timeField_->setFixedWidth(widthOfDay());
    words_ = new QLabel;
    words_->setObjectName(QStringLiteral("lookText"));
    sunWords_ = new QLabel;
    sunWords_->setObjectName(QStringLiteral("sunText"));
    sunWords_->setToolTip(tr("Direction of the sun, clockwise from true north, and its altitude"));
    use_ = pushButton(
        tr("Set as period"), "lookStudy",
        tr("Makes this day or moment the period of the study; Run then computes its figures and errors"));
}

void TimeStrip::makePlayer() {
    play_ = new QToolButton;
    play_->setObjectName(QStringLiteral("playSun"));
    play_->setCheckable(true);
    play_->setAutoRaise(true);
    play_->setToolTip(tr("Plays the sun and its shadows (Shift+Space)"));
    play_->setIcon(makeIcon(QStringLiteral("play")));
    loop_ = shortList("playLoop", {tr("through the day"), tr("through the year")},
                      tr("Play from sunrise to sunset of one date, or one time of day through the year"));
    speed_ =
        shortList("playSpeed", {tr("slowly"), tr("steadily"), tr("fast")},
                  tr("Half an hour, an hour and a half or four hours of the day in a second;\nof the year, "
                     "as many weeks"));
    speed_->setCurrentIndex(1);
    ticks_ = new QTimer(this);
    ticks_->setInterval(tickMs);
}

void TimeStrip::place() {
    auto* player = new QHBoxLayout;
    for (QWidget* widget :
         {static_cast<QWidget*>(play_), static_cast<QWidget*>(loop_), static_cast<QWidget*>(speed_)})
        player->addWidget(widget);
    auto* span = new QHBoxLayout;
    span->addWidget(span_);
    span->addWidget(use_);
    span->addStretch(1);
    auto* grid = new QGridLayout(this);
    grid->setContentsMargins(12, 2, 12, 2);
    grid->setVerticalSpacing(0);
    grid->addLayout(player, 0, 0);
    grid->addLayout(span, 1, 0);
    grid->addWidget(dateField_, 0, 1);
    grid->addWidget(timeField_, 1, 1);
    grid->addWidget(date_, 0, 2);
    grid->addWidget(time_, 1, 2);
    grid->addWidget(sunWords_, 0, 3);
    grid->addWidget(words_, 1, 3);
    grid->setColumnStretch(2, 1);
    grid->setSizeConstraint(QLayout::SetNoConstraint);
}

QSize TimeStrip::minimumSizeHint() const { return {minStripWidth, QWidget::minimumSizeHint().height()}; }

void TimeStrip::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    const bool full = width() >= fullWidth, wordy = width() >= wordyWidth;
    const int sunWidth = fontMetrics().horizontalAdvance(QStringLiteral("Sun 208° SSW, 88° high "));
    for (QWidget* widget : {loop_, speed_}) widget->setVisible(full);
    words_->setVisible(width() >= answerWidth);
    sunWords_->setVisible(wordy);
    static_cast<QGridLayout*>(layout())->setColumnMinimumWidth(3, wordy ? sunWidth : 0);
}

void TimeStrip::connectFields() {
    connect(span_, &QComboBox::currentIndexChanged, this, [this](int chosen) {
        ShownTime look = look_;
        look.span = ShownSpan(chosen);
        take(look);
    });
    connect(date_, &QSlider::valueChanged, this, [this](int day) {
        ShownTime look = look_;
        look.date = civilOf(firstOfYear(look_.date).addDays(day));
        look.span == ShownSpan::day ? take(look) : takeMoment(look);
    });
    connect(time_, &QSlider::valueChanged, this, [this](int minutes) {
        ShownTime look = look_;
        look.at = std::chrono::minutes(minutes);
        takeMoment(look);
    });
    connect(dateField_, &QLineEdit::editingFinished, this, [this] {
        const QDate date = parseDay(dateField_->text(), dateOf(look_.date));
        if (!date.isValid()) return showLook();
        date_->setValue(int(firstOfYear(look_.date).daysTo(date)));
        showLook();  // a day that was shown already keeps its text
    });
    connect(timeField_, &QLineEdit::editingFinished, this, [this] {
        const QTime time = parseTime(timeField_->text());
        if (time.isValid()) time_->setValue(time.hour() * 60 + time.minute());
        showLook();  // a time that was shown already keeps its text
    });
    connect(use_, &QPushButton::clicked, this, [this] { Q_EMIT taken(look_); });
    connect(play_, &QToolButton::toggled, this, &TimeStrip::setPlaying);
    connect(ticks_, &QTimer::timeout, this, &TimeStrip::step);
}

void TimeStrip::setPeriod(const Period& period) {
    ShownTime look = firstShownTime(period);
    if (look.date.year() == look_.date.year()) look = look_;
    setLook(look);
}

void TimeStrip::setLook(const ShownTime& look) {
    look_ = look;
    showLook();
}

void TimeStrip::choose(ShownTime look) {
    look.date = look_.date.year() / look.date.month() / look.date.day();
    if (!look.date.ok())
        look.date = look_.date.year() / look.date.month() / std::chrono::last;  // 29 February
    take(look);
}

void TimeStrip::setDayOffered(bool offered) {
    auto* entries = qobject_cast<QStandardItemModel*>(span_->model());
    entries->item(int(ShownSpan::day))->setEnabled(offered);
    if (offered || look_.span != ShownSpan::day) return;
    ShownTime look = look_;
    look.span = ShownSpan::period;
    take(look);
}

void TimeStrip::setSun(const SunAtMoment& sun) {
    sun_ = sun;
    sunWords_->setText(describe(sun));
    std::vector<MarkedSlider::Mark> marks;
    for (const auto& minutes : {sun.sunriseMin, sun.sunsetMin})
        if (minutes) marks.push_back({*minutes, describeClock(*minutes)});
    time_->setMarks(marks);
    const bool both = sun.sunriseMin && sun.sunsetMin;
    time_->setBright(both ? *sun.sunriseMin : 0, both ? *sun.sunsetMin : -1);
}

void TimeStrip::setAnswer(const ShownTime& of, const QString& words) {
    words_->setText(of.span == ShownSpan::day ? QStringLiteral("%1: %2").arg(describe(of), words) : words);
}

void TimeStrip::move(int minutes, int days) { takeMoment(nudge(look_, minutes, days)); }

void TimeStrip::setPlaying(bool playing) {
    const QSignalBlocker quiet(play_);
    play_->setChecked(playing);
    play_->setIcon(makeIcon(playing ? QStringLiteral("pause") : QStringLiteral("play")));
    if (!playing) return ticks_->stop();
    sinceStep_.start();
    ticks_->start();
}

bool TimeStrip::playing() const { return ticks_->isActive(); }

// By the time that has passed, so that a slow machine skips moments and does not slow down.
void TimeStrip::step() {
    const double seconds = double(sinceStep_.restart()) / 1000;
    takeMoment(advance(look_, sun_, SunLoop(loop_->currentIndex()), seconds,
                       playSpeeds[std::size_t(speed_->currentIndex())]));
}

void TimeStrip::takeMoment(ShownTime look) {
    look.span = ShownSpan::moment;
    take(look);
}

void TimeStrip::take(const ShownTime& look) {
    if (look == look_) return;
    look_ = look;
    showLook();
    Q_EMIT lookChanged(look_);
}

void TimeStrip::showLook() {
    const QSignalBlocker span(span_), date(date_), time(time_), dateField(dateField_), timeField(timeField_);
    const QDate first = firstOfYear(look_.date);
    span_->setCurrentIndex(int(look_.span));
    date_->setMaximum(first.daysInYear() - 1);
    date_->setValue(int(first.daysTo(dateOf(look_.date))));
    time_->setValue(int(look_.at.count()));
    dateField_->setText(locale().toString(dateOf(look_.date), shortDay()));
    timeField_->setText(timeOf(look_.at).toString(QStringLiteral("HH:mm")));
    if (look_.span == ShownSpan::period) words_->clear();
    use_->setVisible(look_.span != ShownSpan::period);
    showMarks();
}

// Solstices and equinoxes to the day, as planners name them.
void TimeStrip::showMarks() {
    const QDate first = firstOfYear(look_.date);
    std::vector<MarkedSlider::Mark> marks;
    for (const QDate date : {QDate(first.year(), 3, 21), QDate(first.year(), 6, 21),
                             QDate(first.year(), 9, 22), QDate(first.year(), 12, 21)})
        marks.push_back({int(first.daysTo(date)), locale().toString(date, tr("d MMM")),
                         locale().toString(date, QStringLiteral("MMM"))});
    date_->setMarks(marks);
}

}  // namespace noonmark
