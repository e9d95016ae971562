#include "app/gui/base/files/file_endings.h"

#include <QObject>
#include <algorithm>

#include "scenarios/project/project_file.h"

namespace noonmark {

namespace {

QStringList withoutDots(const std::vector<std::string_view>& endings) {
    QStringList list;
    for (const std::string_view ending : endings)
        list += QString::fromLatin1(ending.data(), qsizetype(ending.size())).mid(1);
    return list;
}

}  // namespace

QStringList endingsOf(std::initializer_list<FileKind> kinds) { return withoutDots(listEndings(kinds)); }

QStringList pictureEndings() {
    QStringList endings;
    for (const Format& format : coreFormats())
        if (format.isPicture) endings += withoutDots(format.endings);
    return endings;
}

QString withoutEndings(QString name) {
    const QStringList endings =
        endingsOf({FileKind::footprints, FileKind::terrain, FileKind::cityJson, FileKind::mesh});
    const auto chop = [&name](const QString& ending) {
        const qsizetype length = ending.size() + 1;
        if (name.size() <= length || !name.endsWith(QLatin1Char('.') + ending, Qt::CaseInsensitive))
            return false;
        name.chop(length);
        return true;
    };
    while (std::ranges::any_of(endings, chop)) {
    }
    return name;
}

QString makeFileFilter(const QString& name, const QStringList& endings) {
    QStringList patterns;
    for (const QString& ending : endings) patterns += QStringLiteral("*.") + ending;
    return QStringLiteral("%1 (%2)").arg(name, patterns.join(u' '));
}

QString makeCityFilters() {
    const QString project = QString::fromLatin1(projectEnding).mid(1);
    const QStringList maps = endingsOf({FileKind::footprints}), terrain = endingsOf({FileKind::terrain}),
                      models = endingsOf({FileKind::cityJson, FileKind::mesh});
    QStringList all = QStringList{project} + maps + models + terrain;
    all.removeDuplicates();
    return QStringList{makeFileFilter(QObject::tr("Projects, cities and terrain"), all),
                       makeFileFilter(QObject::tr("Projects"), {project}),
                       makeFileFilter(QObject::tr("Footprints"), maps),
                       makeFileFilter(QObject::tr("3D models and meshes"), models),
                       makeFileFilter(QObject::tr("Terrain"), terrain),
                       QObject::tr("All files (*)")}
        .join(QStringLiteral(";;"));
}

}  // namespace noonmark
