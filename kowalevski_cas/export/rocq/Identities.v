(** Identities between values, decided by computing with polynomials.

    An expression becomes a polynomial with integer coefficients in names and in inverses
    of expressions. Rules, whose left sides are monomials, bring it into a normal form;
    what else has an inverse is multiplied out. *)

From Coq Require Import ZArith Field List Ring_theory Ring_polynom.
Require Import Expressions Values.
Import ListNotations.

(** * Polynomials *)

Definition poly : Type := Pol Z.

Definition constant (z : Z) : poly := Pc z.
Definition padd : poly -> poly -> poly := Padd 0%Z Z.add Z.eqb.
Definition pmul : poly -> poly -> poly := Pmul 0%Z 1%Z Z.add Z.mul Z.eqb.
Definition popp : poly -> poly := Popp Z.opp.

Definition rules : Type := list (Z * Mon * poly).

Definition reduced (known : rules) (p : poly) : poly :=
  PNSubstL 0%Z 1%Z Z.add Z.mul Z.eqb Z.quotrem p known 1000 1000.

Fixpoint ppow (known : rules) (p : poly) (n : nat) : poly :=
  match n with
  | O => constant 1
  | S O => p
  | S n => reduced known (pmul p (ppow known p n))
  end.

(** The polynomial of an expression, in the unknowns of a list. *)

Fixpoint unknown (order : list expr) (e : expr) : option poly :=
  match order with
  | [] => None
  | a :: rest =>
    if same a e then Some (PX (constant 1) 1 (constant 0))
    else option_map (mkPinj 1) (unknown rest e)
  end.

Definition both (f : poly -> poly -> poly) (p q : option poly) : option poly :=
  match p, q with Some p, Some q => Some (f p q) | _, _ => None end.

Fixpoint polynomial (order : list expr) (known : rules) (e : expr) : option poly :=
  match e with
  | Var _ | Div _ _ => unknown order e
  | Num z => Some (constant z)
  | Add a b => both padd (polynomial order known a) (polynomial order known b)
  | Opp a => option_map popp (polynomial order known a)
  | Mul a b =>
    both (fun p q => reduced known (pmul p q)) (polynomial order known a) (polynomial order known b)
  | Pow a n => option_map (fun p => ppow known p n) (polynomial order known a)
  end.

(** Equations with a monomial on the left are rules. *)

Definition equations : Type := list (expr * expr).

Fixpoint as_rules (order : list expr) (facts : equations) : rules :=
  match facts with
  | [] => []
  | (a, b) :: rest =>
    match polynomial order [] a, polynomial order [] b with
    | Some p, Some q =>
      match mon_of_pol 0%Z Z.eqb p with
      | Some m => (m, q) :: as_rules order rest
      | None => as_rules order rest
      end
    | _, _ => as_rules order rest
    end
  end.

(** The first unknown is the inverse of [d], a polynomial in the others: a polynomial
    times a power of [d] is one in the others, too. *)

Definition others (j : positive) (p : poly) : poly :=
  match j with xH => p | _ => Pinj (Pos.pred j) p end.

Fixpoint cleared (d p : poly) : poly * nat :=
  match p with
  | Pc z => (Pc z, O)
  | Pinj j p => (others j p, O)
  | PX p i q =>
    let '(p, k) := cleared d p in
    let n := (Pos.to_nat i + k)%nat in
    (padd p (pmul (ppow [] d n) q), n)
  end.

(** Whether a polynomial vanishes; the inverses in [under] are multiplied out. *)

Fixpoint vanishing (under : table) (order : list expr) (facts : equations) (p : poly) : bool :=
  match under with
  | [] => Peq Z.eqb (reduced (as_rules order facts) p) (constant 0)
  | (d, _) :: rest =>
    match polynomial (map snd rest ++ order) [] d with
    | Some d => vanishing rest order facts (fst (cleared d p))
    | None => false
    end
  end.

Definition decide
  (under : table) (order : list expr) (facts : equations) (known : table) (a b : expr) : bool :=
  let all := map snd under ++ order in
  match polynomial all (as_rules all facts) (plain known (a - b)) with
  | Some p => vanishing under order facts p
  | None => false
  end.

(** * What they mean *)

Section Identities.

Variable R : Type.
Variables zero one : R.
Variables add mul sub : R -> R -> R.
Variable opp : R -> R.
Variable div : R -> R -> R.
Variable inv : R -> R.
Variable R_field : field_theory zero one add mul sub opp div inv (@eq R).
Add Field R_is_field : R_field.
Variable v : nat -> R.
Notation val := (value R zero one add mul opp div v).
Notation integer := (integer_value R zero one add mul opp).
Notation power := (power_value R one mul).

Lemma positive_succ (p : positive) :
  positive_value R one add mul (Pos.succ p) = add one (positive_value R one add mul p).
Proof. induction p as [p I|p I|]; cbn; try rewrite I; ring. Qed.

Lemma positive_add (p q : positive) :
  positive_value R one add mul (p + q) =
  add (positive_value R one add mul p) (positive_value R one add mul q).
Proof.
  induction p as [|p I] using Pos.peano_ind.
  - rewrite Pos.add_1_l. apply positive_succ.
  - rewrite Pos.add_succ_l, !positive_succ, I. ring.
Qed.

Lemma positive_mul (p q : positive) :
  positive_value R one add mul (p * q) =
  mul (positive_value R one add mul p) (positive_value R one add mul q).
Proof.
  induction p as [|p I] using Pos.peano_ind.
  - rewrite Pos.mul_1_l. cbn. ring.
  - rewrite Pos.mul_succ_l, positive_add, positive_succ, I. ring.
Qed.

Lemma integer_sub_positive (p q : positive) :
  integer (Z.pos_sub p q) = sub (integer (Zpos p)) (integer (Zpos q)).
Proof.
  rewrite Z.pos_sub_spec. destruct (Pos.compare_spec p q) as [E|L|L].
  - subst. cbn. ring.
  - rewrite <- (Pos.sub_add q p L) at 2. cbn. rewrite positive_add. ring.
  - rewrite <- (Pos.sub_add p q L) at 2. cbn. rewrite positive_add. ring.
Qed.

Lemma integer_add (x y : Z) : integer (x + y) = add (integer x) (integer y).
Proof.
  destruct x as [|p|p], y as [|q|q]; cbn -[Z.pos_sub]; try ring;
  try (rewrite integer_sub_positive; cbn; ring); rewrite positive_add; ring.
Qed.

Lemma integer_opp (x : Z) : integer (- x) = opp (integer x).
Proof. destruct x; cbn; ring. Qed.

Lemma integer_mul (x y : Z) : integer (x * y) = mul (integer x) (integer y).
Proof. destruct x as [|p|p], y as [|q|q]; cbn; try rewrite positive_mul; ring. Qed.

Lemma integers :
  ring_morph zero one add mul sub opp (@eq R) 0%Z 1%Z Z.add Z.mul Z.sub Z.opp Z.eqb integer.
Proof.
  split; try reflexivity.
  - exact integer_add.
  - intros x y. unfold Z.sub. rewrite integer_add, integer_opp. ring.
  - exact integer_mul.
  - exact integer_opp.
  - intros x y H. rewrite (proj1 (Z.eqb_eq _ _) H). reflexivity.
Qed.

Lemma quotients : div_theory (@eq R) Z.add Z.mul integer Z.quotrem.
Proof.
  split. intros a b. generalize (Z.quotrem_eq a b).
  destruct (Z.quotrem a b) as [q r]. intros ->. rewrite Z.mul_comm. reflexivity.
Qed.

Let same_in_R := Eqsth R.
Let congruent := Eq_ext add mul opp.
Let ring_R := Rth_ARth same_in_R congruent (F_R R_field).

Notation at_values p l := (Pphi zero add mul integer l p).

Lemma padd_value (p q : poly) (l : list R) :
  at_values (padd p q) l = add (at_values p l) (at_values q l).
Proof. exact (Padd_ok same_in_R congruent ring_R integers q p l). Qed.

Lemma pmul_value (p q : poly) (l : list R) :
  at_values (pmul p q) l = mul (at_values p l) (at_values q l).
Proof. exact (Pmul_ok same_in_R congruent ring_R integers p q l). Qed.

Lemma popp_value (p : poly) (l : list R) : at_values (popp p) l = opp (at_values p l).
Proof. exact (Popp_ok same_in_R congruent ring_R integers p l). Qed.

Notation hold_at known l := (MPcond zero one add mul (@eq R) integer known l).

Lemma reduced_value (known : rules) (p : poly) (l : list R) :
  hold_at known l -> at_values (reduced known p) l = at_values p l.
Proof.
  intros H. symmetry.
  exact (PNSubstL_ok same_in_R congruent ring_R integers quotients 1000 1000 known p l H).
Qed.

Lemma ppow_value (known : rules) (p : poly) (n : nat) (l : list R) :
  hold_at known l -> at_values (ppow known p n) l = power (at_values p l) n.
Proof.
  intros H. induction n as [|[|n] I]; try reflexivity.
  change (ppow known p (S (S n))) with (reduced known (pmul p (ppow known p (S n)))).
  rewrite reduced_value, pmul_value, I by exact H. reflexivity.
Qed.

Notation unknowns order := (map val order).

Lemma unknown_value (order : list expr) (e : expr) :
  forall p, unknown order e = Some p -> at_values p (unknowns order) = val e.
Proof.
  induction order as [|a rest I]; cbn [unknown]; intros p H; [discriminate H|].
  destruct (same a e) eqn:E.
  - injection H as <-. rewrite <- (same_value R zero one add mul opp div v _ _ E). cbn. ring.
  - destruct (unknown rest e) as [q|]; [|discriminate H]. injection H as <-.
    rewrite <- (I q eq_refl). exact (mkPinj_ok zero add mul same_in_R integer 1 _ q).
Qed.

Lemma polynomial_value (order : list expr) (known : rules) (e : expr) :
  hold_at known (unknowns order) ->
  forall p, polynomial order known e = Some p -> at_values p (unknowns order) = val e.
Proof.
  intros K. induction e as [n|z|a A b B|a A|a A b B|a A b B|a A n]; intros p H;
  try exact (unknown_value _ _ _ H); cbn [polynomial] in H.
  - injection H as <-. reflexivity.
  - destruct (polynomial order known a); [|discriminate H].
    destruct (polynomial order known b); [|discriminate H]. injection H as <-.
    rewrite padd_value, (A _ eq_refl), (B _ eq_refl). reflexivity.
  - destruct (polynomial order known a); [|discriminate H]. injection H as <-.
    rewrite popp_value, (A _ eq_refl). reflexivity.
  - destruct (polynomial order known a); [|discriminate H].
    destruct (polynomial order known b); [|discriminate H]. injection H as <-.
    rewrite reduced_value, pmul_value, (A _ eq_refl), (B _ eq_refl) by exact K. reflexivity.
  - destruct (polynomial order known a); [|discriminate H]. injection H as <-.
    rewrite ppow_value, (A _ eq_refl) by exact K. reflexivity.
Qed.

Fixpoint hold (facts : equations) : Prop :=
  match facts with
  | [] => True
  | (a, b) :: rest => val a = val b /\ hold rest
  end.

Lemma as_rules_hold (order : list expr) (facts : equations) :
  hold facts -> hold_at (as_rules order facts) (unknowns order).
Proof.
  induction facts as [|[a b] rest I]; intros H; [exact H|]. destruct H as [E H].
  cbn [as_rules].
  destruct (polynomial order [] a) as [p|] eqn:P; [|exact (I H)].
  destruct (polynomial order [] b) as [q|] eqn:Q; [|exact (I H)].
  destruct (mon_of_pol 0%Z Z.eqb p) as [m|] eqn:M; [|exact (I H)].
  split; [|exact (I H)].
  rewrite (mon_of_pol_ok same_in_R congruent ring_R integers p M).
  rewrite (polynomial_value order [] a Logic.I p P), (polynomial_value order [] b Logic.I q Q).
  exact E.
Qed.

Lemma others_value (j : positive) (p : poly) (x : R) (l : list R) :
  at_values (others j p) l = at_values (Pinj j p) (x :: l).
Proof.
  destruct (Pos.eq_dec j 1) as [->|N]; [reflexivity|].
  assert (E : others j p = Pinj (Pos.pred j) p) by (destruct j; [reflexivity|reflexivity|contradiction]).
  rewrite E. cbn [Pphi]. rewrite <- (Pos.succ_pred j N) at 2.
  rewrite BinList.jump_succ. cbn [BinList.jump]. rewrite BinList.jump_tl. reflexivity.
Qed.

Lemma power_positive (x : R) (i : positive) : pow_pos mul x i = power x (Pos.to_nat i).
Proof.
  induction i as [|i I] using Pos.peano_ind; [reflexivity|].
  rewrite Pos2Nat.inj_succ, (power_step _ _ _ _ _ _ _ _ _ R_field), <- I.
  apply (pow_pos_succ same_in_R (Rmul_ext congruent)). intros. ring.
Qed.

Lemma power_add (x : R) (m n : nat) : power x (m + n) = mul (power x m) (power x n).
Proof.
  induction m as [|m I]; [cbn; ring|]. cbn [Nat.add].
  rewrite !(power_step _ _ _ _ _ _ _ _ _ R_field), I. ring.
Qed.

Lemma cleared_value (d p : poly) (x : R) (l : list R) :
  mul (at_values d l) x = one ->
  at_values (fst (cleared d p)) l =
  mul (power (at_values d l) (snd (cleared d p))) (at_values p (x :: l)).
Proof.
  intros U. induction p as [z|j p _|p I i q _].
  - cbn. ring.
  - cbn [cleared fst snd]. rewrite (others_value j p x l). cbn. ring.
  - cbn [cleared]. destruct (cleared d p) as [r k]. cbn [fst snd] in *.
    rewrite padd_value, pmul_value, ppow_value, I by exact Logic.I. cbn [Pphi List.hd List.tl].
    rewrite power_positive, power_add.
    assert (P := power_inverse _ _ _ _ _ _ _ _ _ R_field _ _ (Pos.to_nat i) U).
    transitivity (add
      (mul (mul (power (at_values d l) (Pos.to_nat i)) (power x (Pos.to_nat i)))
        (mul (power (at_values d l) k) (at_values p (x :: l))))
      (mul (mul (power (at_values d l) (Pos.to_nat i)) (power (at_values d l) k))
        (at_values q l))); [rewrite P|]; ring.
Qed.

Lemma without_power (x y z : R) (n : nat) :
  mul x y = one -> mul (power x n) z = zero -> z = zero.
Proof.
  intros U H. assert (P := power_inverse _ _ _ _ _ _ _ _ _ R_field _ _ n U).
  transitivity (mul (power y n) (mul (power x n) z)); [|rewrite H; ring].
  transitivity (mul (mul (power x n) (power y n)) z); [rewrite P|]; ring.
Qed.

Notation sound known := (sound R zero one add mul opp div v known).

Lemma vanishing_value (under : table) (order : list expr) (facts : equations) :
  sound under -> hold facts ->
  forall p, vanishing under order facts p = true ->
  at_values p (unknowns (map snd under ++ order)) = zero.
Proof.
  induction under as [|[d u] rest I]; intros S F p H; cbn [vanishing] in H.
  - cbn [map app]. rewrite <- (reduced_value _ p _ (as_rules_hold order facts F)).
    exact (Peq_ok same_in_R congruent integers _ _ H (unknowns order)).
  - destruct S as [U S].
    destruct (polynomial (map snd rest ++ order) [] d) as [q|] eqn:Q; [|discriminate H].
    assert (V := I S F _ H). cbn [map app].
    rewrite <- (polynomial_value _ [] d Logic.I q Q) in U.
    rewrite (cleared_value q p _ _ U) in V. exact (without_power _ _ _ _ U V).
Qed.

Theorem decided
  (under : table) (order : list expr) (facts : equations) (known : table) (a b : expr) :
  sound under -> hold facts -> sound known ->
  decide under order facts known a b = true -> val a = val b.
Proof.
  intros U F K H. unfold decide in H.
  destruct (polynomial _ _ _) as [p|] eqn:P; [|discriminate H].
  apply (plainly _ _ _ _ _ _ _ _ _ R_field v known _ _ K).
  rewrite <- (polynomial_value _ _ _ (as_rules_hold _ _ F) p P).
  exact (vanishing_value under order facts U F p H).
Qed.

(** Divisors with their inverses; each may rest on those before it. *)

Fixpoint decide_all
  (under : table) (order : list expr) (facts : equations) (known : table) : bool :=
  match known with
  | [] => true
  | (b, c) :: rest =>
    decide_all under order facts rest && decide under order facts rest (b * c) 1
  end.

Theorem all_sound (under : table) (order : list expr) (facts : equations) (known : table) :
  sound under -> hold facts -> decide_all under order facts known = true -> sound known.
Proof.
  intros U F. induction known as [|[b c] rest I]; cbn [decide_all]; intros H; [exact Logic.I|].
  apply andb_prop in H. destruct H as [H G]. split; [|exact (I H)].
  exact (decided under order facts rest (b * c) 1 U F (I H) G).
Qed.

End Identities.
