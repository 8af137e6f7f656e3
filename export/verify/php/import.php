<?php declare(strict_types=1);

/**
 * Imports a problem package with DOMjudge's own ImportProblemService; prints what it made, as JSON.
 *
 *     php import.php DOMJUDGE PACKAGE.zip SCRATCH
 *     php import.php DOMJUDGE --test-group FILE
 *
 * DOMJUDGE: a checkout. The importer, the entities, their validation, the annotations of
 * submissions and the YAML are DOMjudge's and Symfony's code. Stand-ins: the database, the event
 * log, the queue of submissions, and the cleaner of SVG, which keeps everything here.
 */

namespace CollisionCourse;

use App\Entity\Contest;
use App\Entity\ContestProblem;
use App\Entity\Problem;
use App\Entity\Team;
use App\Entity\Testcase;
use App\Entity\User;
use App\Service\ImportProblemService;
use Psr\Log\NullLogger;
use Symfony\Component\Validator\Validation;
use Symfony\Component\Validator\Validator\ValidatorInterface;
use Symfony\Component\Yaml\Yaml;

require __DIR__ . '/database.php';

// Debian's packages of the libraries; each registers its own dependencies.
const LIBRARIES = [
    'Doctrine/Common/Collections', 'Psr/Log', 'Symfony/Component/HttpFoundation',
    'Symfony/Component/HttpKernel', 'Symfony/Component/PropertyAccess',
    'Symfony/Component/Security/Core', 'Symfony/Component/Validator', 'Symfony/Component/Yaml',
];
// The languages that DOMjudge allows when it is installed, and their suffixes.
const LANGUAGES = [
    'c' => ['c'], 'cpp' => ['cpp', 'cc', 'cxx', 'c++'], 'java' => ['java'],
    'python3' => ['py'],
];

function load(string $webapp): void
{
    foreach (LIBRARIES as $library) {
        $path = "/usr/share/php/$library/autoload.php";
        if (is_file($path)) {
            require_once $path;
        }
    }
    spl_autoload_register(function (string $class) use ($webapp): void {
        $path = $webapp . '/src/' . str_replace('\\', '/', substr($class, strlen('App\\'))) . '.php';
        if (str_starts_with($class, 'App\\') && is_file($path)) {
            require_once $path;
        }
    });
}

/** Return the default of each setting, as DOMjudge's own file has it. */
function defaults(string $domjudge): array
{
    $settings = [];
    foreach (Yaml::parseFile("$domjudge/etc/db-config.yaml") as $category) {
        foreach ($category['items'] as $item) {
            $settings[$item['name']] = $item['default_value'];
        }
    }
    return $settings;
}

function import(string $domjudge, string $package, string $scratch): array
{
    $database = new Database();
    $user = (new User())->setTeam((new Team())->setName('jury'));
    $contest = new Contest();
    set($contest, 'cid', 1);
    set($user->getTeam(), 'teamid', 1);
    foreach ([$user, $user->getTeam(), $contest] as $entity) {
        $database->persist($entity);
    }
    $service = new ImportProblemService(
        $database,
        new NullLogger(),
        new Installation($user, $scratch),
        new Settings(defaults($domjudge)),
        new NoEvents(),
        $queue = new Queue(),
        validator()
    );
    $zip = new \ZipArchive();
    if ($zip->open($package, \ZipArchive::RDONLY) !== true) {
        throw new \RuntimeException("$package: cannot be opened as a zip");
    }
    $messages = [];
    $problem = $service->importZippedProblem($zip, basename($package), null, $contest, $messages);
    return [
        'messages' => $messages,
        'problem' => $problem === null ? null : described($problem, $database),
        'submissions' => array_map(
            fn($each) => [
                'name' => $each[0], 'language' => $each[1],
                'expected' => $each[2]->getExpectedResults(),
            ],
            $queue->submitted
        ),
    ];
}

/** Return Symfony's validator, which reads the rules of the entities. */
function validator(): ValidatorInterface
{
    $builder = Validation::createValidatorBuilder();
    if (method_exists($builder, 'enableAttributeMapping')) {
        return $builder->enableAttributeMapping()->getValidator();
    }
    return $builder->enableAnnotationMapping(true)->getValidator();  // before Symfony 6.4
}

function described(Problem $problem, Database $database): array
{
    $in_contest = $database->of(ContestProblem::class)[0];
    return [
        'name' => $problem->getName(),
        'external_id' => $problem->getExternalid(),
        'short_name' => $in_contest->getShortname(),
        'time_limit_s' => $problem->getTimelimit(),
        'memory_kib' => $problem->getMemlimit(),
        'output_kib' => $problem->getOutputlimit(),
        'types' => $problem->getTypesAsString(),
        'compare' => $problem->getCompareExecutable()?->getExecid(),
        'statement_type' => $problem->getProblemstatementType(),
        'statement_bytes' => strlen((string)$problem->getProblemStatementContent()?->getContent()),
        'test_cases' => array_map(
            fn(Testcase $case) => [
                'name' => $case->getOrigInputFilename(),
                'rank' => $case->getRank(),
                'sample' => $case->getSample(),
                'md5_input' => $case->getMd5sumInput(),
                'md5_output' => $case->getMd5sumOutput(),
                'description' => $case->getDescription(),
                'image' => $case->getImageType(),
            ],
            $database->of(Testcase::class)
        ),
    ];
}

function test_group(string $file): array
{
    $messages = [];
    $text = file_get_contents($file);
    $group = ImportProblemService::parseTestCaseGroupMeta($text, dirname($file), $messages);
    return [
        'messages' => $messages,
        'aggregation' => $group?->getAggregationType()?->value,
        'accept_score' => $group?->getAcceptScore(),
        'range' => [$group?->getRangeLowerBound(), $group?->getRangeUpperBound()],
        'ignore_sample' => $group?->isIgnoreSample(),
    ];
}

load("$argv[1]/webapp");
require __DIR__ . '/services.php';
$found = $argv[2] === '--test-group' ? test_group($argv[3]) : import($argv[1], $argv[2], $argv[3]);
echo json_encode($found, JSON_PRETTY_PRINT | JSON_UNESCAPED_SLASHES | JSON_THROW_ON_ERROR), "\n";
