#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <QFile>
#include <QLineEdit>
#include <QListWidget>
#include <QMessageBox>
#include <QPushButton>
#include <QRegularExpression>
#include <QTextBrowser>

#include "app/gui/frame/help/guide_window.h"
#include "app/gui/frame/help/help_actions.h"
#include "core/simd/instruction_set.h"
#include "tests/gui/project_window.h"

namespace noonmark {
namespace {

using test::ProjectWindow;
using test::waitFor;

/// The links and pictures of a page in Markdown, without those to the network and to places in the page.
QStringList linksOf(const QString& page) {
    QFile file(QStringLiteral(":/guide/user/%1.md").arg(page));
    EXPECT_TRUE(file.open(QIODevice::ReadOnly)) << page.toStdString();
    static const QRegularExpression link(QStringLiteral("\\]\\(([^)#]+)(#[^)]*)?\\)"));
    QStringList links;
    for (auto found = link.globalMatch(QString::fromUtf8(file.readAll())); found.hasNext();) {
        const QString target = found.next().captured(1);
        if (!target.startsWith(QStringLiteral("http"))) links << target;
    }
    return links;
}

TEST(Guide, IsInTheProgramWithItsPicturesAndTheOtherPages) {
    const QList<GuidePage> pages = listGuidePages();
    EXPECT_GE(pages.size(), 10);
    for (const GuidePage& page : pages) {
        EXPECT_NE(page.title, page.name) << "the page is missing";
        for (const QString& link : linksOf(page.name)) {
            if (!link.endsWith(QStringLiteral(".png"))) continue;
            const QString file = QUrl(QStringLiteral("qrc:/guide/user/")).resolved(QUrl(link)).path();
            EXPECT_TRUE(QFile::exists(QLatin1Char(':') + file))
                << page.name.toStdString() << ": " << link.toStdString();
        }
    }
}

TEST_F(ProjectWindow, F1OpensTheGuideAndALinkTurnsItsPage) {
    window->help().guide()->trigger();
    auto* guide = window->findChild<GuideWindow*>();
    ASSERT_NE(guide, nullptr);
    EXPECT_EQ(guide->page(), QStringLiteral("window"));
    EXPECT_TRUE(guide->text().toPlainText().contains(QStringLiteral("Changing buildings")));
    Q_EMIT guide->text().anchorClicked(QUrl(QStringLiteral("places.md")));
    EXPECT_EQ(guide->page(), QStringLiteral("places"));
    EXPECT_EQ(&window->help().showGuide({QStringLiteral("review"), {}}), guide) << "one guide, not a second";
}

TEST_F(ProjectWindow, TheGuideIsSearchedPageByPage) {
    GuideWindow& guide = window->help().showGuide({QStringLiteral("window"), {}});
    auto* words = guide.findChild<QLineEdit*>(QStringLiteral("guideSearch"));
    auto* pages = guide.findChild<QListWidget*>();
    words->setText(QStringLiteral("GeoPackage"));
    int shown = 0;
    for (int row = 0; row < pages->count(); ++row) shown += pages->item(row)->isHidden() ? 0 : 1;
    EXPECT_GT(shown, 0);
    EXPECT_LT(shown, pages->count()) << "not every page names it";
    guide.findNext();
    EXPECT_EQ(guide.text().textCursor().selectedText().toLower(), QStringLiteral("geopackage"));
    words->setText(QStringLiteral("no such words anywhere"));
    const QString page = guide.page();
    guide.findNext();
    EXPECT_EQ(guide.page(), page);
    words->clear();
    EXPECT_FALSE(pages->item(0)->isHidden());
}

TEST_F(ProjectWindow, TheKeySheetListsTheKeysOfAllMenusAndTheMouse) {
    window->help().keys()->trigger();
    auto* sheet = window->findChild<KeySheet*>();
    ASSERT_NE(sheet, nullptr);
    const auto rowOf = [&](const QString& keys) {
        for (int row = 0; row < sheet->table().rowCount(); ++row)
            if (sheet->table().item(row, 2)->text().contains(keys)) return row;
        return -1;
    };
    for (const char* keys : {"Ctrl+R", "F5", "F7", "Shift+M", "Ctrl+S", "Ctrl+F1, ?", "wheel"})
        EXPECT_GE(rowOf(QString::fromLatin1(keys)), 0) << keys;
    sheet->findChild<QLineEdit*>(QStringLiteral("keySearch"))->setText(QStringLiteral("wheel"));
    EXPECT_FALSE(sheet->table().isRowHidden(rowOf(QStringLiteral("wheel"))));
    EXPECT_TRUE(sheet->table().isRowHidden(rowOf(QStringLiteral("Ctrl+R"))));
}

TEST_F(ProjectWindow, AboutNamesTheVersionAndTheInstructionSet) {
    const std::string text = makeAboutText().toStdString();
    EXPECT_THAT(text, testing::HasSubstr("Noonmark"));
    EXPECT_THAT(text, testing::HasSubstr(std::string(nameOf(instructionSetInUse()))));
    window->help().about()->trigger();
    EXPECT_NE(window->findChild<QMessageBox*>(QStringLiteral("about")), nullptr);
}

}  // namespace
}  // namespace noonmark
