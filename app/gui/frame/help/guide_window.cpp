#include "app/gui/frame/help/guide_window.h"

#include <QAbstractTextDocumentLayout>
#include <QDesktopServices>
#include <QFile>
#include <QHBoxLayout>
#include <QImage>
#include <QLineEdit>
#include <QListWidget>
#include <QRegularExpression>
#include <QScrollBar>
#include <QTextBlock>
#include <QTextBrowser>
#include <QToolButton>
#include <QUrl>
#include <QWidget>
#include <algorithm>

namespace noonmark {

namespace {

/// A dock or bar by its object name, a dialog by its class.
struct PlaceOfPart {
    const char* part;
    const char* page;
    const char* section;
};

constexpr PlaceOfPart places[] = {
    {"studyDock", "window", "A study"},
    {"elementsDock", "window", "Facades, windows, planes"},
    {"placesDock", "window", "Sun by place"},
    {"resultsDock", "results", "Figures"},
    {"contributionsDock", "window", "Contributions"},
    {"scenariosDock", "window", "Scenarios"},
    {"projectDock", "window", "Scenarios"},
    {"weightsDock", "results", "A score"},
    {"warningsDock", "data", ""},
    {"reviewDock", "window", "Review by a rule"},
    {"reviewFormDock", "window", "Review by a rule"},
    {"pointDock", "window", "Sun and time"},
    {"timeStrip", "window", "Sun and time"},
    {"buildingDock", "window", "Changing buildings"},
    {"towerDock", "window", "Changing buildings"},
    {"treesDock", "window", "Trees"},
    {"modeBar", "window", "Modes"},
    {"noonmark::TimeStrip", "window", "Sun and time"},
    {"noonmark::LegendStrip", "window", "Scenarios"},
    {"noonmark::ExportDialog", "window", "Export"},
    {"noonmark::MovieDialog", "window", "Export"},
    {"noonmark::OpenOptions", "data", ""},
    {"noonmark::LotRoadsDialog", "review", "Rules"},
    {"noonmark::PhotographDialog", "data", "Aerial photograph"},
    {"noonmark::TileDialog", "data", "Aerial photograph"},
    {"noonmark::PreferencesDialog", "window", "Preferences"},
};

}  // namespace

GuidePlace findGuidePlace(const QWidget* widget) {
    for (; widget != nullptr; widget = widget->parentWidget())
        for (const PlaceOfPart& place : places)
            if (widget->objectName() == QLatin1String(place.part) ||
                qstrcmp(widget->metaObject()->className(), place.part) == 0)
                return {QString::fromLatin1(place.page), QString::fromLatin1(place.section)};
    return {QStringLiteral("window"), {}};
}

QString guideLink(const GuidePlace& place) {
    return QStringLiteral("guide:") + place.page + QLatin1Char('#') + place.section;
}

GuidePlace parseGuideLink(const QString& link) {
    const QString rest = link.mid(int(qstrlen("guide:")));
    return {rest.section(QLatin1Char('#'), 0, 0), rest.section(QLatin1Char('#'), 1)};
}

namespace {

const char* const pageNames[] = {"window",  "shadows", "data",   "places",       "review",
                                 "results", "engines", "limits", "command-line", "install"};

QString fileOf(const QString& name) { return QStringLiteral(":/guide/user/%1.md").arg(name); }

// The first heading: "# The window".
QString titleOf(const QString& name) {
    QFile file(fileOf(name));
    if (!file.open(QIODevice::ReadOnly)) return name;
    return QString::fromUtf8(file.readLine()).remove(QLatin1Char('#')).trimmed();
}

QString textOf(const QString& name) {
    QFile file(fileOf(name));
    return file.open(QIODevice::ReadOnly) ? QString::fromUtf8(file.readAll()) : QString();
}

// "A study" is "a-study" in links.
QString fragmentOf(const QString& heading) {
    static const QRegularExpression others(QStringLiteral("[^a-z0-9 -]"));
    return heading.toLower().remove(others).replace(QLatin1Char(' '), QLatin1Char('-'));
}

/// Pictures no wider than the text.
class GuideText final : public QTextBrowser {
public:
    using QTextBrowser::QTextBrowser;
    QVariant loadResource(int type, const QUrl& name) override {
        const QVariant found = QTextBrowser::loadResource(type, name);
        if (type != QTextDocument::ImageResource) return found;
        const QImage image = found.metaType().id() == QMetaType::QByteArray
                                 ? QImage::fromData(found.toByteArray())
                                 : found.value<QImage>();
        const int room = viewport()->width() - 2 * int(document()->documentMargin()) - 8;
        if (image.isNull() || image.width() <= room || room <= 0) return image;
        return image.scaledToWidth(room, Qt::SmoothTransformation);
    }
};

}  // namespace

QList<GuidePage> listGuidePages() {
    QList<GuidePage> pages;
    for (const char* name : pageNames)
        pages << GuidePage{QString::fromLatin1(name), titleOf(QString::fromLatin1(name))};
    return pages;
}

GuideWindow::GuideWindow(QWidget* parent)
    : QDialog(parent), words_(new QLineEdit), pages_(new QListWidget), text_(new GuideText) {
    setWindowTitle(tr("User guide"));
    setAttribute(Qt::WA_DeleteOnClose);
    for (const GuidePage& page : listGuidePages()) {
        auto* item = new QListWidgetItem(page.title, pages_);
        item->setData(Qt::UserRole, page.name);
    }
    pages_->setFixedWidth(250);
    words_->setFixedWidth(250);
    pages_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    text_->setOpenLinks(false);
    auto* back = new QToolButton;
    back->setText(tr("Back"));
    back->setEnabled(false);
    connect(back, &QToolButton::clicked, text_, &QTextBrowser::backward);
    connect(text_, &QTextBrowser::backwardAvailable, back, &QWidget::setEnabled);
    words_->setObjectName(QStringLiteral("guideSearch"));
    words_->setPlaceholderText(tr("Find in the guide"));
    words_->setToolTip(tr("Lists the pages with these words; Enter goes to the next place"));
    words_->setClearButtonEnabled(true);
    connect(words_, &QLineEdit::textChanged, this, &GuideWindow::search);
    connect(words_, &QLineEdit::returnPressed, this, &GuideWindow::findNext);
    pages_->setAccessibleName(tr("Pages of the guide"));
    text_->setAccessibleName(windowTitle());
    auto* side = new QVBoxLayout;
    side->addWidget(back);
    side->addWidget(words_);
    side->addWidget(pages_);
    auto* row = new QHBoxLayout(this);
    row->addLayout(side);
    row->addWidget(text_, 1);
    connect(pages_, &QListWidget::itemClicked, this,
            [this](const QListWidgetItem* item) { showPage(item->data(Qt::UserRole).toString()); });
    connect(text_, &QTextBrowser::sourceChanged, this, &GuideWindow::follow);
    connect(text_, &QTextBrowser::anchorClicked, this, &GuideWindow::open);
    resize(1040, 720);
}

void GuideWindow::showPage(const QString& name, const QString& section) {
    text_->setSource(QUrl(QStringLiteral("qrc") + fileOf(name)), QTextDocument::MarkdownResource);
    showSection(section);
}

// A heading by its text or, as links name it, by that in lower case with dashes.
void GuideWindow::showSection(const QString& section) {
    if (section.isEmpty()) return;
    for (QTextBlock block = text_->document()->begin(); block.isValid(); block = block.next()) {
        if (block.blockFormat().headingLevel() == 0) continue;
        const QString heading = block.text().trimmed();
        if (heading != section && fragmentOf(heading) != section) continue;
        // The layout of a page that was just loaded is not complete before the end is asked for.
        text_->document()->documentLayout()->documentSize();
        const QRectF at = text_->document()->documentLayout()->blockBoundingRect(block);
        text_->verticalScrollBar()->setValue(int(at.top()));
        return;
    }
}

void GuideWindow::search(const QString& words) {
    for (int row = 0; row < pages_->count(); ++row) {
        QListWidgetItem* item = pages_->item(row);
        const QString name = item->data(Qt::UserRole).toString();
        const auto count = words.isEmpty() ? 0 : textOf(name).count(words, Qt::CaseInsensitive);
        item->setHidden(!words.isEmpty() && count == 0);
        item->setText(count > 0 ? tr("%1 (%2)").arg(titleOf(name)).arg(count) : titleOf(name));
    }
}

void GuideWindow::findNext() {
    const QString words = words_->text();
    if (words.isEmpty() || text_->find(words)) return;
    const int rows = pages_->count();
    for (int step = 1; step <= rows; ++step) {
        const int row = (std::max(pages_->currentRow(), 0) + step) % rows;
        if (pages_->item(row)->isHidden()) continue;
        showPage(pages_->item(row)->data(Qt::UserRole).toString());
        text_->moveCursor(QTextCursor::Start);
        if (text_->find(words)) return;
    }
}

QString GuideWindow::page() const { return text_->source().fileName().section(QLatin1Char('.'), 0, 0); }

void GuideWindow::follow() {
    for (int row = 0; row < pages_->count(); ++row)
        if (pages_->item(row)->data(Qt::UserRole).toString() == page()) pages_->setCurrentRow(row);
}

void GuideWindow::showLinked(const QUrl& target) {
    text_->setSource(target.adjusted(QUrl::RemoveFragment), QTextDocument::MarkdownResource);
    showSection(target.fragment());
}

// Pages of the guide here; everything else in the browser of the desktop.
void GuideWindow::open(const QUrl& link) {
    const QUrl target = text_->source().resolved(link);
    if (target.scheme() == QStringLiteral("qrc") && QFile::exists(QLatin1Char(':') + target.path()))
        return showLinked(target);
    if (target.scheme().startsWith(QStringLiteral("http"))) QDesktopServices::openUrl(target);
}

}  // namespace noonmark
