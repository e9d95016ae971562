#include "app/gui/docks/sheets/book_view.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QScrollArea>
#include <QSignalBlocker>
#include <QSpinBox>
#include <QToolButton>

#include "app/report/book/print_book.h"

namespace noonmark {

namespace {

// What the zoom list holds besides the resolutions of fixed sizes, in dots per inch.
constexpr int wholePage = 0, pageWidth = -1;
constexpr double pointsPerInch = 72;

}  // namespace

BookView::BookView(QWidget* parent)
    : QWidget(parent),
      number_(new QSpinBox),
      count_(new QLabel),
      chapters_(new QComboBox),
      zoom_(new QComboBox),
      scroll_(new QScrollArea),
      sheet_(new QLabel) {
    sheet_->setAlignment(Qt::AlignCenter);
    sheet_->setObjectName(QStringLiteral("sheetPicture"));
    sheet_->setWordWrap(true);
    scroll_->setWidget(sheet_);
    scroll_->setWidgetResizable(true);
    scroll_->setBackgroundRole(QPalette::Dark);
    sheet_->setForegroundRole(QPalette::HighlightedText);  // white: that of Dark is dark in dark themes
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->addWidget(bar_ = makeBar());
    column->addWidget(scroll_, 1);
    show(nullptr);
}

QWidget* BookView::makeBar() {
    auto* bar = new QWidget;
    auto* line = new QHBoxLayout(bar);
    line->setContentsMargins(0, 0, 0, 0);
    const auto step = [&](const QString& text, const QString& tip, int by) {
        auto* button = new QToolButton;
        button->setText(text);
        button->setToolTip(tip);
        connect(button, &QToolButton::clicked, this, [this, by] { showPage(page() + by); });
        line->addWidget(button);
    };
    step(QStringLiteral("<"), tr("Previous page"), -1);
    number_->setObjectName(QStringLiteral("sheetNumber"));
    line->addWidget(number_);
    line->addWidget(count_);
    step(QStringLiteral(">"), tr("Next page"), 1);
    chapters_->setObjectName(QStringLiteral("sheetChapters"));
    chapters_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    chapters_->setToolTip(tr("Goes to a chapter; the PDF has them as bookmarks"));
    line->addWidget(chapters_, 1);
    zoom_->setToolTip(tr("How large the page is shown"));
    zoom_->addItem(tr("Whole page"), wholePage);
    zoom_->addItem(tr("Page width"), pageWidth);
    for (const int dots : {96, 150, 200}) zoom_->addItem(tr("%1 dots per inch").arg(dots), dots);
    line->addWidget(zoom_);
    connect(number_, &QSpinBox::valueChanged, this, &BookView::paint);
    connect(chapters_, &QComboBox::activated, this, [this] { showPage(chapters_->currentData().toInt()); });
    connect(zoom_, &QComboBox::activated, this, &BookView::paint);
    return bar;
}

int BookView::page() const { return number_->value() - 1; }

void BookView::showPage(int page) { number_->setValue(page + 1); }

void BookView::show(std::shared_ptr<const Book> book, const QString& whyNone) {
    book_ = std::move(book);
    whyNone_ = whyNone.isEmpty() ? tr("Sheets that are to be written are shown here") : whyNone;
    const int pages = book_ ? int(book_->pages.size()) : 0;
    {
        const QSignalBlocker quiet(number_);
        number_->setRange(1, std::max(1, pages));
    }
    count_->setText(pages > 0 ? tr("of %1").arg(pages) : QString());
    for (QWidget* control : bar_->findChildren<QWidget*>()) control->setEnabled(pages > 0);
    listChapters();
    paint();
}

void BookView::listChapters() {
    chapters_->clear();
    if (!book_) return;
    for (std::size_t i = 0; i < book_->pages.size(); ++i) {
        const BookPage& page = book_->pages[i];
        if (!page.bookmark.isEmpty())
            chapters_->addItem(QString(qsizetype{2} * page.level, QLatin1Char(' ')) + page.bookmark, int(i));
    }
}

double BookView::dotsPerInch() const {
    const int chosen = zoom_->currentData().toInt();
    if (chosen > 0) return chosen * devicePixelRatio();
    const QSizeF page = sizePt(book_->setup);
    const QSize room = scroll_->viewport()->size() * devicePixelRatio();
    const double across = room.width() / page.width(), down = room.height() / page.height();
    return std::max(20.0, pointsPerInch * (chosen == pageWidth ? across : std::min(across, down)));
}

void BookView::paint() {
    picture_ = {};
    if (!book_ || book_->pages.empty()) {
        painting_.drop();
        sheet_->setText(whyNone_);
        return;
    }
    const int shown = page();
    for (int i = chapters_->count(); i-- > 0;)
        if (chapters_->itemData(i).toInt() <= shown) {
            chapters_->setCurrentIndex(i);
            break;
        }
    painting_.start<QImage>(
        tr("Painting the page"),
        [book = book_, shown, dots = dotsPerInch()](Progress&, const std::stop_token&) -> Result<QImage> {
            return makePagePicture(*book, std::size_t(shown), dots);
        },
        [this](Result<QImage> painted) {
            if (painted) take(*std::move(painted));
        });
}

void BookView::take(QImage picture) {
    picture_ = std::move(picture);
    QPixmap pixels = QPixmap::fromImage(picture_);
    pixels.setDevicePixelRatio(devicePixelRatio());
    sheet_->setPixmap(pixels);
}

void BookView::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    if (zoom_->currentData().toInt() <= 0) paint();
}

}  // namespace noonmark
