-- What the figures are made of. Every view has the key of a case: version, set_name, number.

-- Cases that hide nothing: those of the group 'nothing', and some of others.
CREATE TEMP VIEW hides_nothing AS
SELECT version, set_name, number FROM bench_case c
WHERE NOT EXISTS (SELECT 1 FROM hidden_law h WHERE (h.version, h.set_name, h.number) = (c.version, c.set_name, c.number));

-- Cases whose hidden law makes no difference: the refitted base leaves no larger error, and the oracle, where it was
-- asked, does not tell the law from nothing. (A random force can make both errors as large although the data tell.)
CREATE TEMP VIEW absorbs AS
SELECT version, set_name, number FROM bench_case c
WHERE c.absorbed AND NOT EXISTS (SELECT 1 FROM oracle_rival o
                                 WHERE (o.version, o.set_name, o.number) = (c.version, c.set_name, c.number)
                                   AND o.effect = '' AND o.told_apart = 1);

-- Cases of the group 'withheld' whose first answer names what the oracle does not tell from the hidden law: it began its
-- search there, and had not found it when it said what to withhold. A right answer was left in the library.
CREATE TEMP VIEW not_withheld AS
SELECT DISTINCT version, set_name, number
FROM bench_case c JOIN reported r USING (version, set_name, number)
JOIN oracle_rival o USING (version, set_name, number, effect, place)
WHERE c.group_name = 'withheld' AND r.round = 1 AND o.told_apart = 0;

-- A case and its first diagnosis; those of `not_withheld` count nowhere. `strength` is the class that the measured one
-- belongs to. `kind` is what the data hold: 'nothing' also where the refitted base explains them. `form` is that of the
-- hidden laws.
CREATE TEMP VIEW judged AS
SELECT c.version, c.set_name, c.number, c.group_name, c.rig, c.noise, c.failure,
       CASE WHEN c.strength < 2.1 THEN 1.5 WHEN c.strength < 5.5 THEN 3 WHEN c.strength >= 5.5 THEN 10 END AS strength,
       c.strength IS NOT NULL AS made,
       CASE WHEN (c.version, c.set_name, c.number) IN absorbs OR (c.version, c.set_name, c.number) IN hides_nothing
              THEN 'nothing'
            WHEN c.group_name = 'withheld' THEN 'withheld'
            WHEN c.group_name = 'two_effects' THEN 'two'
            ELSE 'one' END AS kind,
       CASE WHEN (c.version, c.set_name, c.number) IN absorbs OR (c.version, c.set_name, c.number) IN hides_nothing
              THEN 'nothing'
            WHEN c.group_name = 'two_effects' THEN 'two effects'
            ELSE (SELECT h.effect FROM hidden_law h
                  WHERE (h.version, h.set_name, h.number, h.law) = (c.version, c.set_name, c.number, 0)) END AS effect,
       CASE WHEN (c.version, c.set_name, c.number) IN absorbs OR (c.version, c.set_name, c.number) IN hides_nothing
              THEN 'nothing'
            WHEN EXISTS (SELECT 1 FROM hidden_law h WHERE (h.version, h.set_name, h.number)
                                                        = (c.version, c.set_name, c.number) AND NOT h.library_form)
              THEN 'another form'
            ELSE 'the library''s form' END AS form,
       d.verdict, d.probability, d.seconds
FROM bench_case c
LEFT JOIN diagnosis d ON (d.version, d.set_name, d.number, d.round) = (c.version, c.set_name, c.number, 1)
WHERE (c.version, c.set_name, c.number) NOT IN not_withheld;

-- What an answer names: the effects of its first model and what the data do not tell from the last of them.
CREATE TEMP VIEW reported AS
SELECT r.version, r.set_name, r.number, r.round, r.effect, r.place, min(r.look_alike) AS look_alike
FROM ranked_effect r
JOIN diagnosis d ON (d.version, d.set_name, d.number, d.round) = (r.version, r.set_name, r.number, r.round)
WHERE r.rank = 1 AND d.verdict = 'effect_found'
GROUP BY r.version, r.set_name, r.number, r.round, r.effect, r.place;

-- Each hidden law: whether the first answer names it, how many of its other members the oracle tells from the law, whether
-- it names the law or what the oracle does not tell from it, whether one of the first three models or classes names it,
-- whether any
-- round's answer does. An effect that stands in the model beside the law is not excused by being like it. An effect
-- that the oracle did not look at
-- counts as told apart.
CREATE TEMP VIEW law_found AS
SELECT h.version, h.set_name, h.number, h.law,
       EXISTS (SELECT 1 FROM reported r
               WHERE (r.version, r.set_name, r.number, r.round) = (h.version, h.set_name, h.number, 1)
                 AND (r.effect, r.place) = (h.effect, h.place)) AS named,
       (SELECT count(*) FROM reported r
        WHERE (r.version, r.set_name, r.number, r.round) = (h.version, h.set_name, h.number, 1)
          AND (r.effect, r.place) <> (h.effect, h.place)
          AND NOT (EXISTS (SELECT 1 FROM oracle_rival o
                           WHERE (o.version, o.set_name, o.number, o.law) = (h.version, h.set_name, h.number, h.law)
                             AND (o.effect, o.place) = (r.effect, r.place) AND o.told_apart = 0)
                   AND (r.look_alike
                        OR NOT EXISTS (SELECT 1 FROM reported q
                                       WHERE (q.version, q.set_name, q.number, q.round, q.look_alike)
                                           = (h.version, h.set_name, h.number, 1, 0)
                                         AND (q.effect, q.place) = (h.effect, h.place))))) AS others,
       EXISTS (SELECT 1 FROM reported r
               WHERE (r.version, r.set_name, r.number, r.round) = (h.version, h.set_name, h.number, 1)
                 AND ((r.effect, r.place) = (h.effect, h.place)
                      OR EXISTS (SELECT 1 FROM oracle_rival o
                                 WHERE (o.version, o.set_name, o.number, o.law) = (h.version, h.set_name, h.number, h.law)
                                   AND (o.effect, o.place) = (r.effect, r.place) AND o.told_apart = 0))) AS named_alike,
       EXISTS (SELECT 1 FROM ranked_effect r
               WHERE (r.version, r.set_name, r.number, r.round) = (h.version, h.set_name, h.number, 1)
                 AND r.rank <= 3 AND (r.effect, r.place) = (h.effect, h.place)) AS in_three,
       EXISTS (SELECT 1 FROM reported r
               WHERE (r.version, r.set_name, r.number) = (h.version, h.set_name, h.number)
                 AND (r.effect, r.place) = (h.effect, h.place)) AS ever_named
FROM hidden_law h;

-- Of two hidden laws one that the oracle does not tell from nothing in its place: the base or the other takes it up, and an
-- answer without it is whole.
CREATE TEMP VIEW untold_law AS
SELECT h.* FROM hidden_law h
WHERE EXISTS (SELECT 1 FROM oracle_rival o WHERE (o.version, o.set_name, o.number, o.law, o.effect, o.told_apart)
                                               = (h.version, h.set_name, h.number, h.law, '', 0))
  AND EXISTS (SELECT 1 FROM oracle_rival o WHERE (o.version, o.set_name, o.number, o.effect, o.told_apart)
                                               = (h.version, h.set_name, h.number, '', 1) AND o.law <> h.law);

CREATE TEMP VIEW told_law AS
SELECT h.* FROM hidden_law h
WHERE NOT EXISTS (SELECT 1 FROM untold_law u WHERE (u.version, u.set_name, u.number, u.law)
                                                 = (h.version, h.set_name, h.number, h.law));

-- What the oracle does not tell from a hidden law that is told from nothing: the same data, in other words.
CREATE TEMP VIEW stand_in AS
SELECT o.version, o.set_name, o.number, o.law, o.effect, o.place
FROM oracle_rival o JOIN told_law h USING (version, set_name, number, law) WHERE o.told_apart = 0;

-- An added effect stands for a hidden law if it is that, or a stand-in.
CREATE TEMP VIEW stands_for AS
SELECT a.version, a.set_name, a.number, a.effect, a.place, h.law
FROM added_effect a
JOIN hidden_law h ON (h.version, h.set_name, h.number) = (a.version, a.set_name, a.number)
WHERE (h.effect, h.place) = (a.effect, a.place)
   OR EXISTS (SELECT 1 FROM stand_in o
              WHERE (o.version, o.set_name, o.number, o.law) = (h.version, h.set_name, h.number, h.law)
                AND (o.effect, o.place) = (a.effect, a.place));

-- How diagnose, add, diagnose again ended. The true set holds each law that is told; one that is not may be in it.
CREATE TEMP VIEW loop_end AS
SELECT j.version, j.set_name, j.number,
       j.failure IS NULL
       AND (SELECT d.verdict FROM diagnosis d WHERE (d.version, d.set_name, d.number) = (j.version, j.set_name, j.number)
            ORDER BY d.round DESC LIMIT 1) <> 'effect_found'
       AND (SELECT count(*) FROM added_effect a WHERE (a.version, a.set_name, a.number) = (j.version, j.set_name, j.number))
         = (SELECT count(*) FROM hidden_law h WHERE (h.version, h.set_name, h.number) = (j.version, j.set_name, j.number)
              AND (NOT EXISTS (SELECT 1 FROM untold_law u WHERE (u.version, u.set_name, u.number, u.law)
                                                              = (h.version, h.set_name, h.number, h.law))
                   OR EXISTS (SELECT 1 FROM added_effect a WHERE (a.version, a.set_name, a.number, a.effect, a.place)
                                                               = (h.version, h.set_name, h.number, h.effect, h.place))))
       AND NOT EXISTS (SELECT 1 FROM added_effect a
                       WHERE (a.version, a.set_name, a.number) = (j.version, j.set_name, j.number)
                         AND NOT EXISTS (SELECT 1 FROM stands_for s
                                         WHERE (s.version, s.set_name, s.number, s.effect, s.place)
                                             = (a.version, a.set_name, a.number, a.effect, a.place)))
       AND NOT EXISTS (SELECT 1 FROM told_law h
                       WHERE (h.version, h.set_name, h.number) = (j.version, j.set_name, j.number)
                         AND NOT EXISTS (SELECT 1 FROM stands_for s
                                         WHERE (s.version, s.set_name, s.number, s.law)
                                             = (h.version, h.set_name, h.number, h.law))) AS true_set
FROM judged j;

-- Whether the first verdict is right. An effect is right when a hidden law is among those named.
CREATE TEMP VIEW verdict_right AS
SELECT j.version, j.set_name, j.number, j.verdict, j.probability,
       CASE j.kind WHEN 'nothing' THEN j.verdict = 'nothing_missing'
                   WHEN 'withheld' THEN j.verdict = 'not_in_library'
                   ELSE EXISTS (SELECT 1 FROM law_found f
                                WHERE (f.version, f.set_name, f.number) = (j.version, j.set_name, j.number) AND f.named)
       END AS is_right
FROM judged j
WHERE j.made AND j.verdict IS NOT NULL;

-- Held-out error of what was found over that of the refitted truth, squared, meaned over the channels.
CREATE TEMP VIEW held_out_ratio AS
SELECT t.version, t.set_name, t.number,
       CASE WHEN count(f.rmse) = count(*) THEN avg(f.rmse * f.rmse / (t.rmse * t.rmse)) END AS square
FROM held_out t
LEFT JOIN held_out f ON (f.version, f.set_name, f.number, f.channel, f.stage)
                      = (t.version, t.set_name, t.number, t.channel, 'found')
WHERE t.stage = 'truth' AND t.rmse > 0
GROUP BY t.version, t.set_name, t.number;

-- Intervals of parameters whose true values are known, of what the first diagnosis found.
CREATE TEMP VIEW effect_interval AS
SELECT i.version, i.set_name, i.number, i.effect AS of_effect, i.lower, i.upper, i.truth, w.width
FROM interval i
JOIN hidden_law h ON (h.version, h.set_name, h.number, h.effect, h.place)
                   = (i.version, i.set_name, i.number, i.effect, i.place)
LEFT JOIN oracle_width w ON (w.version, w.set_name, w.number, w.parameter)
                          = (i.version, i.set_name, i.number, i.effect || '.' || i.parameter)
WHERE i.round = 1 AND i.truth IS NOT NULL AND i.lower IS NOT NULL AND i.upper IS NOT NULL;

-- Intervals of the free values, where the model that they were fitted with is right and none of them takes up a law.
CREATE TEMP VIEW value_interval AS
SELECT i.version, i.set_name, i.number, i.lower, i.upper, i.truth, w.width
FROM interval i
JOIN judged j ON (j.version, j.set_name, j.number) = (i.version, i.set_name, i.number)
JOIN loop_end l ON (l.version, l.set_name, l.number) = (i.version, i.set_name, i.number)
LEFT JOIN oracle_width w ON (w.version, w.set_name, w.number, w.parameter)
                          = (i.version, i.set_name, i.number, i.parameter)
WHERE i.round = 0 AND i.truth IS NOT NULL AND i.lower IS NOT NULL AND i.upper IS NOT NULL AND j.made
  AND (SELECT d.verdict FROM diagnosis d WHERE (d.version, d.set_name, d.number) = (i.version, i.set_name, i.number)
       ORDER BY d.round DESC LIMIT 1) = 'nothing_missing'
  AND NOT EXISTS (SELECT 1 FROM untold_law u WHERE (u.version, u.set_name, u.number) = (j.version, j.set_name, j.number))
  AND ((j.kind IN ('one', 'two') AND l.true_set) OR ((j.version, j.set_name, j.number) IN hides_nothing AND j.verdict = 'nothing_missing'));

-- Cases that `run --diagnoses` did not go on with although something was found, and, where no case of a set was gone on
-- with, all others of the set: they say nothing of the loop, and those alone that found nothing would say something false.
CREATE TEMP VIEW cut_short AS
SELECT d.version, d.set_name, d.number, d.round
FROM diagnosis d JOIN bench_case c USING (version, set_name, number)
WHERE c.failure IS NULL AND d.verdict = 'effect_found' AND d.round < 3
  AND d.round = (SELECT max(round) FROM diagnosis e WHERE (e.version, e.set_name, e.number) = (d.version, d.set_name, d.number))
  AND NOT EXISTS (SELECT 1 FROM added_effect a WHERE (a.version, a.set_name, a.number, a.round)
                                                   = (d.version, d.set_name, d.number, d.round))
UNION
SELECT c.version, c.set_name, c.number, 1
FROM bench_case c
WHERE NOT EXISTS (SELECT 1 FROM added_effect a WHERE (a.version, a.set_name) = (c.version, c.set_name))
  AND EXISTS (SELECT 1 FROM diagnosis d JOIN bench_case f USING (version, set_name, number)
              WHERE (d.version, d.set_name, d.verdict) = (c.version, c.set_name, 'effect_found')
                AND f.failure IS NULL);

-- The second diagnosis of cases whose first one added what is hidden and told, or what the oracle does not tell from it, and
-- nothing besides; without a verdict where it ended early.
CREATE TEMP VIEW second_diagnosis AS
SELECT j.version, j.set_name, j.number, d.verdict
FROM judged j
LEFT JOIN diagnosis d ON (d.version, d.set_name, d.number, d.round) = (j.version, j.set_name, j.number, 2)
WHERE j.made AND j.kind IN ('one', 'two')
  AND EXISTS (SELECT 1 FROM added_effect a
              WHERE (a.version, a.set_name, a.number, a.round) = (j.version, j.set_name, j.number, 1))
  AND NOT EXISTS (SELECT 1 FROM added_effect a
                  WHERE (a.version, a.set_name, a.number, a.round) = (j.version, j.set_name, j.number, 1)
                    AND NOT EXISTS (SELECT 1 FROM stands_for s
                                    WHERE (s.version, s.set_name, s.number, s.effect, s.place)
                                        = (a.version, a.set_name, a.number, a.effect, a.place)))
  AND NOT EXISTS (SELECT 1 FROM told_law h
                  WHERE (h.version, h.set_name, h.number) = (j.version, j.set_name, j.number)
                    AND NOT EXISTS (SELECT 1 FROM stands_for s JOIN added_effect a
                                      ON (a.version, a.set_name, a.number, a.effect, a.place)
                                       = (s.version, s.set_name, s.number, s.effect, s.place)
                                    WHERE (s.version, s.set_name, s.number, s.law)
                                        = (h.version, h.set_name, h.number, h.law) AND a.round = 1));

-- How many tests told the first answer from its closest look-alike (7: six did not), and what was left then: the
-- 'truth', a 'stand-in' that the oracle did not tell from it on the data before, or 'another'. `truth_in_question`: one
-- of the two is hidden.
CREATE TEMP VIEW settled AS
SELECT s.version, s.set_name, s.number, r.choice, r.tests,
       CASE WHEN r.effect IS NULL THEN NULL
            WHEN EXISTS (SELECT 1 FROM hidden_law h WHERE (h.version, h.set_name, h.number, h.effect, h.place)
                                                        = (s.version, s.set_name, s.number, r.effect, r.place))
              THEN 'truth'
            WHEN EXISTS (SELECT 1 FROM stand_in o WHERE (o.version, o.set_name, o.number, o.effect, o.place)
                                                      = (s.version, s.set_name, s.number, r.effect, r.place))
              THEN 'stand-in'
            ELSE 'another' END AS left_over,
       EXISTS (SELECT 1 FROM hidden_law h WHERE (h.version, h.set_name, h.number) = (s.version, s.set_name, s.number)
                                            AND ((h.effect, h.place) = (s.effect, s.place)
                                              OR (h.effect, h.place) = (s.rival_effect, s.rival_place)))
         AS truth_in_question
FROM settling s
JOIN settling_run r ON (r.version, r.set_name, r.number) = (s.version, s.set_name, s.number)
JOIN judged j ON (j.version, j.set_name, j.number) = (s.version, s.set_name, s.number)
WHERE j.made AND j.kind IN ('one', 'two')
  AND NOT EXISTS (SELECT 1 FROM settling_run q WHERE (q.version, q.set_name, q.number) = (s.version, s.set_name, s.number)
                                                 AND q.tests IS NULL);

-- Of the whitened sum of squares, without noise: what the nearest effect leaves of those that the oracle tells from the
-- hidden law. Where the law and all that is like it are withheld, that is what shows that it is not in the library.
CREATE TEMP VIEW left_by_the_rest AS
SELECT version, set_name, number, min(non_centrality) AS left_over
FROM oracle_rival WHERE told_apart AND effect <> '' GROUP BY version, set_name, number;

-- The figures. `kind`: share (values from 0 to 1; Wilson), mean and median (bootstrap), calibration (expected error of a
-- stated probability over ten bins; bootstrap), and what that is by chance (draws of who is right). `least` and `most`
-- are the goal.
CREATE TEMP VIEW figure (position, figure, title, kind, least, most) AS VALUES
  (1, 'top1_1.5', 'first class right, strength 1.5 (score 1/(1 + k))', 'share', 0.85, NULL),
  (2, 'top1_3', 'first class right, strength 3 (score 1/(1 + k))', 'share', 0.95, NULL),
  (3, 'top1_10', 'first class right, strength 10 (score 1/(1 + k))', 'share', NULL, NULL),
  (4, 'named', 'names the hidden effect, or one that the oracle does not tell from it', 'share', NULL, NULL),
  (5, 'top3', 'in the first class, or one of the first three models', 'share', 0.99, NULL),
  (6, 'false_positive', 'something found where nothing is hidden', 'share', 0.03, 0.07),
  (7, 'nothing_missing', 'nothing_missing where nothing is hidden', 'share', NULL, NULL),
  (8, 'not_in_library', 'not_in_library where the effect is withheld', 'share', 0.9, NULL),
  (9, 'not_in_library_left', 'the same, where the nearest of the rest leaves 1 000 or more of the whitened sum of squares', 'share', NULL, NULL),
  (10, 'both_found', 'two effects, each told from its absence: both found', 'share', 0.8, NULL),
  (11, 'true_set', 'diagnose, add, again ends at the true set', 'share', 0.85, NULL),
  (12, 'second_nothing', 'once all that was hidden is added, the second diagnosis says nothing_missing', 'share', 0.95, NULL),
  (13, 'held_out', 'held-out error at most 1.1 times that of the refitted truth', 'share', 0.95, NULL),
  (14, 'coverage', '95 % intervals of the effects cover the truth', 'share', 0.92, 0.97),
  (15, 'value_coverage', '95 % intervals of the free values cover the truth, where the model is right', 'share', 0.92, 0.97),
  (16, 'width', 'width of the effects'' intervals over the oracle''s', 'median', NULL, 1.5),
  (17, 'value_width', 'width of the free values'' intervals over the oracle''s, where the model is right', 'median', NULL, 1.5),
  (18, 'brier', 'Brier score of the verdict''s probability', 'mean', NULL, NULL),
  (19, 'calibration', 'calibration error of the verdict''s probability', 'calibration', NULL, NULL),
  (22, 'calibration_by_chance', 'what that would be by chance, were these probabilities exact', 'calibration by chance', NULL, NULL),
  (23, 'cannot_tell', 'cannot_tell where the oracle can tell', 'share', NULL, NULL),
  (24, 'tests_chosen', 'tests until the answer is told from its closest look-alike, chosen (7: not with six)', 'median', NULL, 2),
  (25, 'tests_random', 'tests until the answer is told from its closest look-alike, random (7: not with six)', 'median', NULL, NULL),
  (26, 'settled_chosen', 'told apart by six chosen tests at most', 'share', NULL, NULL),
  (27, 'settled_random', 'told apart by six random tests at most', 'share', NULL, NULL),
  (28, 'settled_none', 'told apart without a test when the two are asked about alone (not in the four above)', 'share', NULL, NULL),
  (29, 'left_chosen', 'what chosen tests left is the hidden effect, where it was one of the two', 'share', NULL, NULL),
  (30, 'left_random', 'what random tests left is the hidden effect, where it was one of the two', 'share', NULL, NULL),
  (31, 'seconds', 'seconds of a diagnosis', 'median', NULL, NULL),
  (32, 'failed', 'ended early (a refusal, a crash, no time left)', 'share', NULL, NULL);

-- One row for each case (or interval) that a figure is made of. `probability` is for the calibration alone. Cases that
-- ended early count as wrong; those that could not be made count in `failed` alone.
CREATE TEMP VIEW figure_value AS
SELECT version, set_name, number, 'top1_' || CASE strength WHEN 1.5 THEN '1.5' WHEN 3 THEN '3' WHEN 10 THEN '10' END
       AS figure, CASE WHEN named THEN 1.0 / (1 + others) ELSE 0.0 END AS value, NULL AS probability
  FROM judged JOIN law_found USING (version, set_name, number) WHERE made AND kind = 'one' AND strength IN (1.5, 3, 10)
UNION ALL
SELECT version, set_name, number, 'named', named_alike, NULL
  FROM judged JOIN law_found USING (version, set_name, number) WHERE made AND kind = 'one'
UNION ALL
SELECT version, set_name, number, 'top3', in_three, NULL
  FROM judged JOIN law_found USING (version, set_name, number) WHERE made AND kind = 'one'
UNION ALL
SELECT version, set_name, number, 'false_positive', coalesce(verdict IN ('effect_found', 'not_in_library'), 1), NULL
  FROM judged WHERE made AND kind = 'nothing'
UNION ALL
SELECT version, set_name, number, 'nothing_missing', coalesce(verdict = 'nothing_missing', 0), NULL
  FROM judged WHERE made AND kind = 'nothing'
UNION ALL
SELECT version, set_name, number, 'not_in_library', coalesce(verdict = 'not_in_library', 0), NULL
  FROM judged WHERE made AND kind = 'withheld'
UNION ALL
SELECT version, set_name, number, 'not_in_library_left', coalesce(verdict = 'not_in_library', 0), NULL
  FROM judged JOIN left_by_the_rest USING (version, set_name, number) WHERE made AND kind = 'withheld' AND left_over >= 1000
UNION ALL
SELECT version, set_name, number, 'both_found', min(ever_named), NULL
  FROM judged JOIN law_found USING (version, set_name, number) JOIN told_law USING (version, set_name, number, law)
  WHERE made AND kind = 'two'
  GROUP BY version, set_name, number HAVING count(*) > 1
UNION ALL
SELECT version, set_name, number, 'true_set', coalesce(true_set, 0), NULL
  FROM judged JOIN loop_end USING (version, set_name, number) WHERE made AND kind IN ('one', 'two')
    AND (version, set_name, number) NOT IN (SELECT version, set_name, number FROM cut_short)
UNION ALL
SELECT version, set_name, number, 'second_nothing', coalesce(verdict = 'nothing_missing', 0), NULL FROM second_diagnosis
UNION ALL
SELECT version, set_name, number, 'held_out', coalesce(square <= 1.1 * 1.1, 0), NULL
  FROM judged JOIN held_out_ratio USING (version, set_name, number) WHERE made AND kind IN ('one', 'two')
    AND (version, set_name, number) NOT IN (SELECT version, set_name, number FROM cut_short WHERE round = 1)
UNION ALL
SELECT version, set_name, number, 'coverage', truth BETWEEN lower AND upper, NULL
  FROM judged JOIN effect_interval USING (version, set_name, number) WHERE made AND kind IN ('one', 'two')
UNION ALL
SELECT version, set_name, number, 'value_coverage', truth BETWEEN lower AND upper, NULL FROM value_interval
UNION ALL
SELECT version, set_name, number, 'width', (upper - lower) / width, NULL
  FROM judged JOIN effect_interval USING (version, set_name, number) WHERE made AND kind IN ('one', 'two') AND width > 0
UNION ALL
SELECT version, set_name, number, 'value_width', (upper - lower) / width, NULL FROM value_interval WHERE width > 0
UNION ALL
SELECT version, set_name, number, 'brier', (probability - is_right) * (probability - is_right), NULL
  FROM verdict_right WHERE verdict <> 'cannot_tell' AND probability IS NOT NULL
UNION ALL
SELECT version, set_name, number, 'calibration', is_right, probability
  FROM verdict_right WHERE verdict <> 'cannot_tell' AND probability IS NOT NULL
UNION ALL
SELECT version, set_name, number, 'calibration_by_chance', is_right, probability
  FROM verdict_right WHERE verdict <> 'cannot_tell' AND probability IS NOT NULL
UNION ALL
SELECT j.version, j.set_name, j.number, 'cannot_tell', coalesce(j.verdict = 'cannot_tell', 1), NULL
  FROM judged j WHERE j.made AND j.kind IN ('one', 'two')
    AND EXISTS (SELECT 1 FROM oracle_rival o WHERE (o.version, o.set_name, o.number) = (j.version, j.set_name, j.number)
                AND o.effect = '' AND o.told_apart)
UNION ALL
SELECT version, set_name, number, 'tests_' || choice, tests, NULL FROM settled
UNION ALL
SELECT version, set_name, number, 'settled_' || choice, left_over IS NOT NULL, NULL FROM settled
UNION ALL
SELECT version, set_name, number, 'left_' || choice, left_over = 'truth', NULL
  FROM settled WHERE truth_in_question AND left_over IS NOT NULL
UNION ALL
SELECT version, set_name, number, 'seconds', seconds, NULL FROM judged WHERE seconds IS NOT NULL
UNION ALL
SELECT version, set_name, number, 'failed', failure IS NOT NULL, NULL FROM judged;

-- Hidden effect and what the first diagnosis named first.
CREATE TEMP VIEW confusion AS
SELECT j.version, j.set_name, j.number, CASE j.kind WHEN 'withheld' THEN 'withheld' ELSE j.effect END AS hidden,
       CASE WHEN j.verdict IS NULL THEN 'ended early'
            WHEN j.verdict = 'effect_found' THEN
              (SELECT r.effect FROM ranked_effect r
               WHERE (r.version, r.set_name, r.number, r.round, r.rank, r.position)
                   = (j.version, j.set_name, j.number, 1, 1, 0))
            ELSE j.verdict END AS named
FROM judged j
WHERE j.made AND j.kind <> 'two';

-- Each method that was asked about a case with something or nothing hidden, this program among them where others were
-- asked, too; `chosen` is 0 where it found nothing.
CREATE TEMP VIEW asked AS
SELECT b.version, b.set_name, b.number, b.method, b.chosen > 0 AS chosen, b.seconds, j.kind
  FROM baseline b JOIN judged j USING (version, set_name, number) WHERE j.made
UNION ALL
SELECT j.version, j.set_name, j.number, 'lacuna',
       coalesce(j.verdict IN ('effect_found', 'not_in_library'), 0), d.processor_seconds, j.kind
  FROM judged j LEFT JOIN diagnosis d
    ON (d.version, d.set_name, d.number, d.round) = (j.version, j.set_name, j.number, 1)
 WHERE j.made AND EXISTS (SELECT 1 FROM baseline b
                          WHERE (b.version, b.set_name, b.number) = (j.version, j.set_name, j.number));

-- What a method names, best first: of this program its ranking, without look-alikes.
CREATE TEMP VIEW choice AS
SELECT version, set_name, number, method, rank, effect, place FROM baseline_rank
UNION ALL
SELECT r.version, r.set_name, r.number, 'lacuna', r.rank, r.effect, r.place FROM ranked_effect r
 WHERE r.round = 1 AND NOT r.look_alike
   AND r.position = (SELECT min(q.position) FROM ranked_effect q
                     WHERE (q.version, q.set_name, q.number, q.round, q.rank)
                         = (r.version, r.set_name, r.number, r.round, r.rank));

-- What methods make of the same cases, one choice each: the true effect, or one that the oracle does not tell from it.
CREATE TEMP VIEW baseline_value AS
SELECT version, set_name, number, method, 'first right' AS figure,
       a.chosen AND EXISTS (SELECT 1 FROM choice c JOIN hidden_law h
                            ON (h.version, h.set_name, h.number, h.effect, h.place)
                             = (c.version, c.set_name, c.number, c.effect, c.place)
                            WHERE (c.version, c.set_name, c.number, c.method, c.rank)
                                = (a.version, a.set_name, a.number, a.method, 1)) AS value
  FROM asked a WHERE a.kind = 'one'
UNION ALL
SELECT version, set_name, number, method, 'first right, or not told from it by the oracle',
       a.chosen AND EXISTS (SELECT 1 FROM choice c JOIN hidden_law h
                            ON (h.version, h.set_name, h.number) = (c.version, c.set_name, c.number)
                            WHERE (c.version, c.set_name, c.number, c.method, c.rank)
                                = (a.version, a.set_name, a.number, a.method, 1)
                              AND ((c.effect, c.place) = (h.effect, h.place)
                                   OR EXISTS (SELECT 1 FROM oracle_rival o
                                              WHERE (o.version, o.set_name, o.number, o.law, o.effect, o.place)
                                                  = (h.version, h.set_name, h.number, h.law, c.effect, c.place)
                                                AND o.told_apart = 0)))
  FROM asked a WHERE a.kind = 'one'
UNION ALL
SELECT version, set_name, number, method, 'among the first three',
       EXISTS (SELECT 1 FROM choice c JOIN hidden_law h ON (h.version, h.set_name, h.number, h.effect, h.place)
                                                         = (c.version, c.set_name, c.number, c.effect, c.place)
               WHERE (c.version, c.set_name, c.number, c.method) = (a.version, a.set_name, a.number, a.method)
                 AND c.rank <= 3)
  FROM asked a WHERE a.kind = 'one'
UNION ALL
SELECT version, set_name, number, method, 'something found where nothing is hidden', chosen
  FROM asked WHERE kind = 'nothing'
UNION ALL
SELECT version, set_name, number, method, 'processor seconds', seconds FROM asked WHERE seconds IS NOT NULL;
