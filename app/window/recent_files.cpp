#include "app/window/recent_files.h"

#include <QFileInfo>
#include <QSettings>

namespace noonmark {

namespace {

const QString key = QStringLiteral("recentFiles");

QString absolute(const QString& file) {
    return file.startsWith(QStringLiteral("sample:")) ? file : QFileInfo(file).absoluteFilePath();
}

}  // namespace

RecentFiles::RecentFiles(QSettings& settings) : settings_(settings) {}

QStringList RecentFiles::entries() const { return settings_.value(key).toStringList(); }

void RecentFiles::add(const QStringList& files) {
    QStringList paths;
    for (const QString& file : files) paths << absolute(file);
    const QString entry = paths.join(QLatin1Char('\n'));
    QStringList list = entries();
    list.removeAll(entry);
    list.prepend(entry);
    settings_.setValue(key, list.mid(0, most));
}

void RecentFiles::clear() { settings_.remove(key); }

QStringList RecentFiles::filesOf(const QString& entry) { return entry.split(QLatin1Char('\n')); }

QString RecentFiles::nameOf(const QString& entry) {
    const QStringList files = filesOf(entry);
    const QString first = QFileInfo(files.front()).fileName();
    return files.size() == 1 ? first : QStringLiteral("%1 and %2 more").arg(first).arg(files.size() - 1);
}

}  // namespace noonmark
