<?php declare(strict_types=1);

/** Stand-ins for the database, and for a library that is not packaged in Debian. */

// The class files of DOMjudge name these; only the parts that are used here are defined.
namespace Doctrine\ORM {
    interface EntityManagerInterface
    {
    }
}

namespace enshrined\svgSanitize {
    class Sanitizer
    {
        public function removeRemoteReferences(bool $_remove): void
        {
        }

        public function minify(bool $_minify): void
        {
        }

        public function sanitize(string $svg): string|false
        {
            return simplexml_load_string($svg) === false ? false : $svg;
        }
    }
}

namespace CollisionCourse {
    use App\Entity\Problem;
    use App\Entity\Testcase;
    use Doctrine\ORM\EntityManagerInterface;

    /** Set a property of an entity that only the database sets. */
    function set(object $entity, string $property, mixed $value): void
    {
        (new \ReflectionProperty($entity, $property))->setValue($entity, $value);
    }

    /** A query that finds nothing, whatever it asks: the database is empty. */
    final class EmptyQuery
    {
        public function __call(string $name, array $_arguments): mixed
        {
            return $name === 'getResult' ? [] : $this;
        }
    }

    /** Finds the last stored entity of one class. */
    final class Repository
    {
        public function __construct(private readonly Database $database, private readonly string $class)
        {
        }

        public function find(mixed $_id): ?object
        {
            return $this->database->of($this->class)[0] ?? null;
        }

        public function findOneBy(array $_criteria): ?object
        {
            return $this->find(null);
        }
    }

    /** Stores entities in memory, and numbers problems when they are written, as Doctrine does. */
    final class Database implements EntityManagerInterface
    {
        private array $entities = [];

        public function persist(object $entity): void
        {
            $this->entities[spl_object_id($entity)] = $entity;
        }

        public function of(string $class): array
        {
            return array_values(array_filter($this->entities, fn($each) => $each instanceof $class));
        }

        public function flush(): void
        {
            foreach ($this->of(Problem::class) as $problem) {
                set($problem, 'probid', 1);
            }
        }

        /** Forget what was loaded; a problem that is read again knows its test cases. */
        public function clear(): void
        {
            foreach ($this->of(Problem::class) as $problem) {
                foreach ($this->of(Testcase::class) as $case) {
                    $problem->addTestcase($case);
                }
            }
        }

        public function wrapInTransaction(callable $work): void
        {
            $work();
        }

        public function createQueryBuilder(): EmptyQuery
        {
            return new EmptyQuery();
        }

        public function getRepository(string $class): Repository
        {
            return new Repository($this, $class);
        }
    }
}
