<?php declare(strict_types=1);

/** Stand-ins for the services of DOMjudge that an import uses. */

namespace CollisionCourse;

use App\Entity\Contest;
use App\Entity\Language;
use App\Entity\Submission;
use App\Entity\SubmissionSource;
use App\Entity\Team;
use App\Entity\User;
use App\Service\ConfigurationService;
use App\Service\DOMJudgeService;
use App\Service\EventLogService;
use App\Service\SubmissionService;

/** An installation in which one member of the jury imports a package. */
final class Installation extends DOMJudgeService
{
    public function __construct(private readonly User $me, private readonly string $scratch)
    {
    }

    public function getUser(): ?User
    {
        return $this->me;
    }

    public function getDomjudgeTmpDir(): string
    {
        return $this->scratch;
    }

    public function getAllowedLanguagesForContest(?Contest $_contest): array
    {
        return array_map(
            fn($name, $suffixes) => (new Language())->setExternalid($name)->setExtensions($suffixes),
            array_keys(LANGUAGES),
            LANGUAGES
        );
    }
}

/** The settings as they are when DOMjudge is installed. */
final class Settings extends ConfigurationService
{
    public function __construct(private readonly array $defaults)
    {
    }

    public function get(string $name, bool $onlyIfPublic = false)
    {
        return $this->defaults[$name];
    }
}

/** An event log that keeps nothing. */
final class NoEvents extends EventLogService
{
    public function __construct()
    {
    }

    public function log(
        string $type,
        mixed $dataIds,
        string $action,
        ?int $contestId = null,
        ?string $json = null,
        mixed $ids = null,
        bool $checkEvents = true
    ): void {
    }
}

/** Takes submissions and judges none. submitted: file name, language and entity of each. */
final class Queue extends SubmissionService
{
    public array $submitted = [];

    public function __construct()
    {
    }

    public function submitSolution(
        Team|int $team,
        User|int|null $user,
        mixed $problem,
        Contest|int $contest,
        mixed $language,
        array $files,
        SubmissionSource $source = SubmissionSource::UNKNOWN,
        ?string $juryMember = null,
        mixed $originalSubmission = null,
        ?string $entryPoint = null,
        ?string $externalId = null,
        ?float $submitTime = null,
        ?string &$message = null,
        bool $forceImportInvalid = false,
        bool $deferPostProcessing = false
    ): ?Submission {
        $submission = new Submission();
        $this->submitted[] = [$files[0]->getClientOriginalName(), $language, $submission];
        return $submission;
    }

    public function postProcessSubmissions(array $submissions, Contest $contest): void
    {
    }
}
